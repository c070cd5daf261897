; The line by point-by-point comparison, over unbounded integers.
;
;   xe, ye   the end point, absolute values
;   x, y     the pulses made so far
;   lx, ly   the pulses to go, xe - x and ye - y
;   F        xe*y - ye*x, the deviation function
;
; The rule: x if F >= 0 and xe /= 0, y otherwise. The argument is in docs/proofs/ppc_line.md.
(set-logic QF_NIA)

; lemma: deviation_by_pulses_to_go
; F = ye*lx - xe*ly: F may be counted from the end point as well, for the end point itself has F = 0.
; mutant: replace "(- (* ye lx) (* xe ly))" by "(- (* xe ly) (* ye lx))"
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const x Int)
(declare-const y Int)
(define-fun lx () Int (- xe x))
(define-fun ly () Int (- ye y))
(check-sat) ; expect sat
(assert (not (= (- (* xe y) (* ye x)) (- (* ye lx) (* xe ly)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: x_pulse
; A pulse on x takes ye from F.
; mutant: replace "(- F ye)" by "(+ F ye)"
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const x Int)
(declare-const y Int)
(define-fun F () Int (- (* xe y) (* ye x)))
(check-sat) ; expect sat
(assert (not (= (- (* xe y) (* ye (+ x 1))) (- F ye))))
(check-sat) ; expect unsat
(pop 1)

; lemma: y_pulse
; A pulse on y adds xe to F.
; mutant: replace "(+ F xe)" by "(+ F ye)"
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const x Int)
(declare-const y Int)
(define-fun F () Int (- (* xe y) (* ye x)))
(check-sat) ; expect sat
(assert (not (= (- (* xe (+ y 1)) (* ye x)) (+ F xe))))
(check-sat) ; expect unsat
(pop 1)

; lemma: rule_keeps_the_bounds
; -ye <= F <= xe goes on to hold: an x pulse is made at F >= 0 only, and a y pulse at F < 0, or on
; the line xe = 0, where F stays 0.
; mutant: replace "(>= F 0)" by "(>= F (- 1))"
; mutant: replace "(distinct xe 0)" by "true"
; mutant: replace "(assert (=> (= xe 0) (= F 0)))" by ""
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const F Int)
(declare-const after Int)
(assert (and (>= xe 0) (>= ye 0) (> (+ xe ye) 0)))
(assert (and (<= (- ye) F) (<= F xe)))
; On the line xe = 0 both products of F are 0 until the end, where the machine has stopped.
(assert (=> (= xe 0) (= F 0)))
(assert (= after (ite (and (>= F 0) (distinct xe 0)) (- F ye) (+ F xe))))
(check-sat) ; expect sat
(assert (not (and (<= (- ye) after) (<= after xe) (=> (= xe 0) (= after 0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: x_at_its_end_is_not_fed
; With no x pulses to go, F < 0 calls for y, unless y has none to go either or xe = 0.
; mutant: replace "(= ly 0)" by "false"
; mutant: replace "(= xe 0)" by "false"
; mutant: replace "(< F 0)" by "(> F 0)"
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const lx Int)
(declare-const ly Int)
(define-fun F () Int (- (* ye lx) (* xe ly)))
(assert (and (>= xe 0) (>= ye 0) (>= ly 0)))
(assert (= lx 0))
(check-sat) ; expect sat
(assert (not (or (< F 0) (= ly 0) (= xe 0))))
(check-sat) ; expect unsat
(pop 1)

; lemma: y_at_its_end_is_not_fed
; With no y pulses to go F >= 0, which calls for x. (On the line xe = 0 the machine is done then.)
; mutant: replace "(>= F 0)" by "(> F 0)"
; mutant: replace "(= ly 0)" by "(>= ly 0)"
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const lx Int)
(declare-const ly Int)
(define-fun F () Int (- (* ye lx) (* xe ly)))
(assert (and (>= xe 0) (>= ye 0) (>= lx 0)))
(assert (= ly 0))
(check-sat) ; expect sat
(assert (not (>= F 0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: bounds_mean_one_pulse
; -ye <= F <= xe gives F^2 <= L^2 = xe^2 + ye^2. The distance of (x,y) from the line is |F| / L.
; mutant: replace "(<= (* F F)" by "(< (* F F)"
; mutant: replace "(<= F xe)" by "(<= F (+ xe 1))"
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const F Int)
(assert (and (>= xe 0) (>= ye 0)))
(assert (and (<= (- ye) F) (<= F xe)))
(check-sat) ; expect sat
(assert (not (<= (* F F) (+ (* xe xe) (* ye ye)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: one_pulse_is_never_reached
; Off the axes the distance is even below one pulse: F^2 < L^2.
; mutant: replace "(>= xe 1)" by "(>= xe 0)"
(push 1)
(declare-const xe Int)
(declare-const ye Int)
(declare-const F Int)
(assert (and (>= xe 1) (>= ye 1)))
(assert (and (<= (- ye) F) (<= F xe)))
(check-sat) ; expect sat
(assert (not (< (* F F) (+ (* xe xe) (* ye ye)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: one_pulse_is_the_least_bound
; No smaller bound serves all lines: on the line to (1,ye) the first pulse makes F = -ye, and the
; distance ye / L comes as near to one pulse as one likes. Here 99 hundredths, from ye = 8 on.
; mutant: replace "(>= ye 8)" by "(>= ye 7)"
(push 1)
(declare-const ye Int)
(define-fun after () Int (- 0 ye))
(assert (>= ye 8))
(check-sat) ; expect sat
(assert (not (> (* 10000 (* after after)) (* 9801 (+ (* 1 1) (* ye ye))))))
(check-sat) ; expect unsat
(pop 1)

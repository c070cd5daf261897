; The parabola v^2 = 2*p*u, of whose orientations and branches only magnitudes are left.
;
;   p        the parameter's magnitude
;   u, v     the point, along the axis of symmetry and across it: magnitudes
;   F        v^2 - 2*p*u, the deviation function
;
; A point is within one pulse of the parabola along the axis of symmetry if 2*p*(u - 1) <= v^2 <= 2*p*(u + 1),
; and across it if (v - 1)^2 <= 2*p*u <= (v + 1)^2; within half a pulse likewise. What the rules do to F is
; in the machines' own words, core/src/parabola.
(set-logic QF_NIA)

; lemma: along_pulse
; u + 1 takes 2p from F.
; mutant: replace "(- F (* 2 p))" by "(- F p)"
(push 1)
(declare-const p Int)
(declare-const u Int)
(declare-const v Int)
(define-fun F () Int (- (* v v) (* 2 p u)))
(check-sat) ; expect sat
(assert (not (= (- (* v v) (* 2 p (+ u 1))) (- F (* 2 p)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: across_pulse
; v + 1 adds 2v + 1 to F.
; mutant: replace "(+ F (* 2 v) 1)" by "(+ F (* 2 v))"
(push 1)
(declare-const p Int)
(declare-const u Int)
(declare-const v Int)
(define-fun F () Int (- (* v v) (* 2 p u)))
(check-sat) ; expect sat
(assert (not (= (- (* (+ v 1) (+ v 1)) (* 2 p u)) (+ F (* 2 v) 1))))
(check-sat) ; expect unsat
(pop 1)

; lemma: comparison_keeps_its_bounds
; -2p <= F <= 2v - 2, or F <= 0 where v = 0, goes on to hold.
; mutant: replace "(define-fun outside () Bool (>= F 0))" by "(define-fun outside () Bool (>= F (- 1)))"
; mutant: replace "(define-fun outside () Bool (>= F 0))" by "(define-fun outside () Bool (>= F 1))"
(push 1)
(declare-const p Int)
(declare-const v Int)
(declare-const F Int)
(assert (and (>= p 1) (>= v 0)))
(assert (<= (* (- 2) p) F))
(assert (or (<= F (- (* 2 v) 2)) (<= F 0)))
(define-fun outside () Bool (>= F 0))
(define-fun after () Int (ite outside (- F (* 2 p)) (+ F (* 2 v) 1)))
(define-fun vafter () Int (ite outside v (+ v 1)))
(check-sat) ; expect sat
(assert (not (and (<= (* (- 2) p) after) (or (<= after (- (* 2 vafter) 2)) (<= after 0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: inside_within_a_pulse_along
; -2p <= F <= 0: the parabola is met between u - 1 and u.
; mutant: replace "(* 2 p (- u 1))" by "(- (* 2 p u) p)"
; mutant: replace "(<= F 0)" by "(<= F 1)"
(push 1)
(declare-const p Int)
(declare-const u Int)
(declare-const v Int)
(define-fun F () Int (- (* v v) (* 2 p u)))
(assert (>= p 1))
(assert (<= (* (- 2) p) F))
(assert (<= F 0))
(check-sat) ; expect sat
(assert (not (and (<= (* 2 p (- u 1)) (* v v)) (<= (* v v) (* 2 p u)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_within_a_pulse_across
; 0 <= F <= 2v - 2: it is met between v - 1 and v, and not at v - 1.
; mutant: replace "(- (* 2 v) 2)" by "(- (* 2 v) 1)"
(push 1)
(declare-const p Int)
(declare-const u Int)
(declare-const v Int)
(define-fun F () Int (- (* v v) (* 2 p u)))
(assert (>= v 1))
(assert (<= 0 F))
(assert (<= F (- (* 2 v) 2)))
(check-sat) ; expect sat
(assert (not (and (< (* (- v 1) (- v 1)) (* 2 p u)) (<= (* 2 p u) (* v v)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: nearest_step_keeps_its_bounds
; Let "after" be no farther from 0 than any of the three F; then -max(p,v) <= F <= max(p,v-1) goes on to hold, for the
; v that belongs to it.
; mutant: replace "(<= F (ite (> p (- v 1)) p (- v 1)))" by "true"
; mutant: replace "(<= (- (ite (> p v) p v)) F)" by "true"
; mutant: replace "(and (= after Fd) (= vafter (+ v 1)))" by "(and (= after Fd) (= vafter v))"
(push 1)
(declare-const p Int)
(declare-const v Int)
(declare-const F Int)
(declare-const after Int)
(declare-const vafter Int)
(define-fun Fu () Int (- F (* 2 p)))
(define-fun Fv () Int (+ F (* 2 v) 1))
(define-fun Fd () Int (+ (- F (* 2 p)) (* 2 v) 1))
(assert (and (>= p 1) (>= v 0)))
(assert (<= (- (ite (> p v) p v)) F))
(assert (<= F (ite (> p (- v 1)) p (- v 1))))
(assert (or (and (= after Fu) (= vafter v))
            (and (= after Fv) (= vafter (+ v 1)))
            (and (= after Fd) (= vafter (+ v 1)))))
(define-fun off () Int (ite (< after 0) (- after) after))
(assert (and (<= off (ite (< Fu 0) (- Fu) Fu)) (<= off (ite (< Fv 0) (- Fv) Fv))
             (<= off (ite (< Fd 0) (- Fd) Fd))))
(check-sat) ; expect sat
(assert (not (and (<= (- (ite (> p vafter) p vafter)) after)
                  (<= after (ite (> p (- vafter 1)) p (- vafter 1))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: within_half_a_pulse_along
; |F| <= p: the parabola is met between u - 1/2 and u + 1/2.
; mutant: replace "(<= F p)" by "(<= F (+ p 1))"
; mutant: replace "(<= (- p) F)" by "(<= (- (- p) 1) F)"
(push 1)
(declare-const p Int)
(declare-const u Int)
(declare-const v Int)
(define-fun F () Int (- (* v v) (* 2 p u)))
(assert (<= (- p) F))
(assert (<= F p))
(check-sat) ; expect sat
(assert (not (and (<= (* p (- (* 2 u) 1)) (* v v)) (<= (* v v) (* p (+ (* 2 u) 1))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: within_half_a_pulse_across
; -v <= F <= v - 1: it is met between v - 1/2 and v + 1/2. Four times the squares.
; mutant: replace "(<= F (- v 1))" by "(<= F v)"
; mutant: replace "(<= (- v) F)" by "(<= (- (- v) 2) F)"
(push 1)
(declare-const p Int)
(declare-const u Int)
(declare-const v Int)
(define-fun F () Int (- (* v v) (* 2 p u)))
(assert (>= v 1))
(assert (<= (- v) F))
(assert (<= F (- v 1)))
(check-sat) ; expect sat
(assert (not (and (< (* (- (* 2 v) 1) (- (* 2 v) 1)) (* 8 p u))
                  (< (* 8 p u) (* (+ (* 2 v) 1) (+ (* 2 v) 1))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: way_along_takes_its_parameter
; With d pulses to go along the axis of symmetry, d >= 1, p*d is p at least.
; mutant: replace "(>= d 1)" by "(>= d 0)"
(push 1)
(declare-const p Int)
(declare-const d Int)
(assert (>= p 1))
(assert (>= d 1))
(check-sat) ; expect sat
(assert (not (>= (* p d) p)))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_on_the_parabola_is_not_passed_along
; With v at the end of a parabola through (U,V), and u before it, F > 0, which calls for u: no axis stands before
; its time. V^2 = 2*p*U, and p*U is p*u + p*d with d = U - u pulses to go: so F is 2*p*d there, 2p at least. The
; products are unknowns, of which way_along_takes_its_parameter tells what is needed.
; mutant: replace "(>= pd p)" by "(>= pd 0)"
; mutant: replace "(* 2 (+ pu pd))" by "(+ pu pd)"
(push 1)
(declare-const p Int)
(declare-const pu Int)
(declare-const pd Int)
(declare-const square Int)
(assert (>= p 1))
(assert (>= pd p))
(assert (= square (* 2 (+ pu pd))))
(check-sat) ; expect sat
(assert (not (>= (- square (* 2 pu)) (* 2 p))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_on_the_parabola_is_not_passed_across
; With u at the end and v before it, F < 0, which calls for v.
; mutant: replace "(< v V)" by "(<= v V)"
(push 1)
(declare-const p Int)
(declare-const v Int)
(declare-const U Int)
(declare-const V Int)
(assert (>= p 1))
(assert (and (<= 0 v) (< v V)))
(assert (= (* V V) (* 2 p U)))
(check-sat) ; expect sat
(assert (not (< (- (* v v) (* 2 p U)) 0)))
(check-sat) ; expect unsat
(pop 1)

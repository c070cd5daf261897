; The line in space by point-by-point comparison, the axes m (the longest) and two others.
;
;   em, e    their end coordinates, magnitudes
;   pm, pi   the pulses made so far
;   F        em*pi - e*pm, the deviation function of an axis
(set-logic QF_NIRA)

; lemma: deviation_by_pulses_to_go
; F = e*lm - em*li, with lm and li the pulses to go: the end point has F = 0 too.
; mutant: replace "(- (* e lm) (* em li))" by "(- (* em li) (* e lm))"
(push 1)
(declare-const em Int)
(declare-const e Int)
(declare-const pm Int)
(declare-const pi Int)
(define-fun lm () Int (- em pm))
(define-fun li () Int (- e pi))
(check-sat) ; expect sat
(assert (not (= (- (* em pi) (* e pm)) (- (* e lm) (* em li)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: rule_keeps_the_bounds
; -e <= F < em goes on to hold: e is taken at F >= 0, em added at F < 0.
; mutant: replace "(>= F 0)" by "(>= F (- 1))"
; mutant: replace "(< F 0)" by "(< F 1)"
(push 1)
(declare-const em Int)
(declare-const e Int)
(declare-const F Int)
(declare-const after Int)
(assert (and (<= 0 e) (<= e em) (<= 1 em)))
(assert (and (<= (- e) F) (< F em)))
(assert (or (and (>= F 0) (= after (- F e))) (and (< F 0) (= after (+ F em)))))
(check-sat) ; expect sat
(assert (not (and (<= (- e) after) (< after em))))
(check-sat) ; expect unsat
(pop 1)

; lemma: distance_from_the_line_in_space
; Along the two other axes the point is F1/em and F2/em from the line's point with the same m, so its distance from the line
; is less than the square root of 2.
; mutant: replace "(< F2 em)" by "(<= F2 (* 2.0 em))"
; mutant: replace "(<= (- em) F1)" by "(<= (* (- 2.0) em) F1)"
(push 1)
(declare-const em Real)
(declare-const F1 Real)
(declare-const F2 Real)
(assert (> em 0.0))
(assert (and (<= (- em) F1) (< F1 em)))
(assert (and (<= (- em) F2) (< F2 em)))
(check-sat) ; expect sat
(assert (not (<= (+ (* F1 F1) (* F2 F2)) (* 2.0 em em))))
(check-sat) ; expect unsat
(pop 1)

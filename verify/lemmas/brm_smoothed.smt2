; The smoothed rate multiplier, one axis, in parts of a pulse.
;
;   m        2^k, what the divider divides by
;   q        the pulses of the train so far, and P those passed on
;   s        the share of the line that is due, v*c/2^(n+k)
;   D        the largest deviation of the plain multiplier from its own line
(set-logic QF_NIRA)

; lemma: deviation_is_divided
; |q - m*s| <= D and |m*P - q| <= m/2 give |P - s| <= D/m + 1/2, times m.
; mutant: replace "(+ D (/ m 2.0))" by "D"
; mutant: replace "(<= (- (/ m 2.0)) (- (* m P) q))" by "(<= (- m) (- (* m P) q))"
(push 1)
(declare-const m Real)
(declare-const q Real)
(declare-const P Real)
(declare-const s Real)
(declare-const D Real)
(assert (>= m 1.0))
(assert (and (<= (- D) (- q (* m s))) (<= (- q (* m s)) D)))
(assert (<= (- (/ m 2.0)) (- (* m P) q)))
(assert (<= (- (* m P) q) (/ m 2.0)))
(define-fun bound () Real (+ D (/ m 2.0)))
(check-sat) ; expect sat
(assert (not (and (<= (- bound) (* m (- P s))) (<= (* m (- P s)) bound))))
(check-sat) ; expect unsat
(pop 1)

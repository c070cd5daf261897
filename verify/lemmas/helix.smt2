; The helix: what arc and linear axis share the cycles by.
;
;   T, S     the steps of the longer and of the shorter of the two; T cycles in all
;   h        T halved and rounded down, the remainder register's preset
;   c, P     the cycles and the steps of the shorter made so far
;   R        the remainder register
(set-logic QF_NIA)

; lemma: remainder_from_the_start_and_from_the_end
; R = h + c*S - P*T is R + left*S = h + d*T as well, with left = T - c cycles and d = S - P steps to go.
; mutant: replace "(+ h (* d T))" by "(+ h (* P T))"
(push 1)
(declare-const T Int)
(declare-const S Int)
(declare-const h Int)
(declare-const c Int)
(declare-const P Int)
(define-fun R () Int (- (+ h (* c S)) (* P T)))
(define-fun left () Int (- T c))
(define-fun d () Int (- S P))
(check-sat) ; expect sat
(assert (not (= (+ R (* left S)) (+ h (* d T)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: share_is_kept_to_half_a_step
; 0 <= R < T says that P is within half a step of c*S/T: times 2*T.
; mutant: replace "(< R T)" by "(<= R (+ T 1))"
; mutant: replace "(<= 0 R)" by "(<= (- 1) R)"
(push 1)
(declare-const T Int)
(declare-const S Int)
(declare-const h Int)
(declare-const c Int)
(declare-const P Int)
(define-fun R () Int (- (+ h (* c S)) (* P T)))
(define-fun off () Int (- (* P T) (* c S)))
(assert (>= T 1))
(assert (and (<= (* 2 h) T) (< T (+ (* 2 h) 2))))
(assert (<= 0 R))
(assert (< R T))
(check-sat) ; expect sat
(assert (not (and (<= (- T) (* 2 off)) (<= (* 2 off) T))))
(check-sat) ; expect unsat
(pop 1)

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

; lemma: no_cycle_left_ahead
; What the harnesses know of A = d*T - left*S: with no cycle left it is d*T, which is 0, or T at least.
; mutant: replace "(= left 0)" by "(= left 1)"
(push 1)
(declare-const T Int)
(declare-const S Int)
(declare-const d Int)
(declare-const left Int)
(define-fun A () Int (- (* d T) (* left S)))
(assert (and (<= 0 S) (<= S T)))
(assert (<= 0 d))
(assert (= left 0))
(check-sat) ; expect sat
(assert (not (ite (= d 0) (= A 0) (>= A T))))
(check-sat) ; expect unsat
(pop 1)

; lemma: none_lacking_ahead
; And with no step lacking while there are cycles left, it is -S at most.
; mutant: replace "(= d 0)" by "(= d 1)"
; mutant: replace "(<= 1 left)" by "(<= 0 left)"
(push 1)
(declare-const T Int)
(declare-const S Int)
(declare-const d Int)
(declare-const left Int)
(define-fun A () Int (- (* d T) (* left S)))
(assert (and (<= 0 S) (<= S T)))
(assert (= d 0))
(assert (<= 1 left))
(check-sat) ; expect sat
(assert (not (<= A (- S))))
(check-sat) ; expect unsat
(pop 1)

; lemma: cycle_changes_ahead
; A cycle adds S to it, and a step of the shorter takes T away.
; mutant: replace "(+ (- A T) S)" by "(- (- A T) S)"
(push 1)
(declare-const T Int)
(declare-const S Int)
(declare-const d Int)
(declare-const left Int)
(define-fun A () Int (- (* d T) (* left S)))
(check-sat) ; expect sat
(assert (not (and (= (- (* (- d 1) T) (* (- left 1) S)) (+ (- A T) S))
                  (= (- (* d T) (* (- left 1) S)) (+ A S)))))
(check-sat) ; expect unsat
(pop 1)

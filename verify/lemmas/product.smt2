; What the proofs know of a product of two integers.
;
; A solver for machine words cannot multiply at full width in reasonable time, so the harnesses
; (verify/proofs/src/product.rs) carry a product as a number of its own, of which they assume these
; sentences and no more.
(set-logic QF_NIA)

; lemma: zero
; a * 0 = 0.
; mutant: replace "(= b 0)" by "(= b 1)"
(push 1)
(declare-const a Int)
(declare-const b Int)
(assert (= b 0))
(check-sat) ; expect sat
(assert (not (= (* a b) 0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: one
; a * 1 = a.
; mutant: replace "(= b 1)" by "(= b 2)"
(push 1)
(declare-const a Int)
(declare-const b Int)
(assert (= b 1))
(check-sat) ; expect sat
(assert (not (= (* a b) a)))
(check-sat) ; expect unsat
(pop 1)

; lemma: two_or_more
; A count of two or more gives at least twice the factor: a * b >= 2a for a >= 0, since
; a * b - 2a = a * (b - 2).
; mutant: replace "(>= b 2)" by "(>= b 1)"
; mutant: replace "(assert (>= a 0))" by ""
(push 1)
(declare-const a Int)
(declare-const b Int)
(assert (>= a 0))
(assert (>= b 2))
(check-sat) ; expect sat
(assert (not (>= (* a b) (* 2 a))))
(check-sat) ; expect unsat
(pop 1)

; lemma: one_less
; One count less takes the factor away once: a * (b - 1) = a * b - a.
; mutant: replace "(- (* a b) a)" by "(- (* a b) b)"
(push 1)
(declare-const a Int)
(declare-const b Int)
(check-sat) ; expect sat
(assert (not (= (* a (- b 1)) (- (* a b) a))))
(check-sat) ; expect unsat
(pop 1)

; lemma: bound
; Of factors up to 2^31 = 2147483648 the product is up to 2^62 = 4611686018427387904.
; mutant: replace "4611686018427387904" by "4611686018427387903"
; mutant: replace "(<= a 2147483648)" by "(<= a 2147483649)"
(push 1)
(declare-const a Int)
(declare-const b Int)
(assert (and (<= 0 a) (<= a 2147483648)))
(assert (and (<= 0 b) (<= b 2147483648)))
(check-sat) ; expect sat
(assert (not (and (<= 0 (* a b)) (<= (* a b) 4611686018427387904))))
(check-sat) ; expect unsat
(pop 1)

; lemma: square_beside_zero
; The square one to the left is a square: (c - 1)^2 >= 0, so that c^2 >= 2c - 1.
; mutant: replace "(- (* 2 c) 1)" by "(* 2 c)"
(push 1)
(declare-const c Int)
(check-sat) ; expect sat
(assert (not (>= (* c c) (- (* 2 c) 1))))
(check-sat) ; expect unsat
(pop 1)

; lemma: square_below_the_bound
; Below c = 2^31 the square one to the right is within the bound too: c^2 + 2c + 1 = (c + 1)^2 <= 2^62.
; mutant: replace "(< c 2147483648)" by "(<= c 2147483648)"
(push 1)
(declare-const c Int)
(assert (and (<= 0 c) (< c 2147483648)))
(check-sat) ; expect sat
(assert (not (<= (+ (* c c) (* 2 c) 1) 4611686018427387904)))
(check-sat) ; expect unsat
(pop 1)

; What a bound on F says of the distance from the circle.
;
;   x, y     the present point: magnitudes
;   rho      its distance from the centre, rho*rho = x^2 + y^2
;   R        the radius, a real number, R >= 1
;   F        rho^2 - R^2, the deviation function
;
; The bounds on F are those of minimum deviation (the larger coordinate), of comparison integration
; (the sum of both), and of vector discrimination (twice the larger one).
(set-logic QF_NIRA)

; lemma: coordinates_are_within_the_distance
; max(x, y) <= rho.
; mutant: replace "(* y y)" by "(- (* y y))"
(push 1)
(declare-const x Real)
(declare-const y Real)
(declare-const rho Real)
(assert (and (<= 0.0 x) (<= 0.0 y) (<= 0.0 rho)))
(assert (= (* rho rho) (+ (* x x) (* y y))))
(check-sat) ; expect sat
(assert (not (<= x rho)))
(check-sat) ; expect unsat
(pop 1)

; lemma: sum_is_within_root_two_distances
; (x + y)^2 <= 2*rho^2.
; mutant: replace "(* 2.0 (+ (* x x) (* y y)))" by "(+ (* x x) (* y y))"
(push 1)
(declare-const x Real)
(declare-const y Real)
(check-sat) ; expect sat
(assert (not (<= (* (+ x y) (+ x y)) (* 2.0 (+ (* x x) (* y y))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: inside_by_half_the_slope
; -F <= c*rho inside the circle: it is c/2 from there at most. (c = 1: half a pulse; c = sqrt 2; c = 2.)
; mutant: replace "(<= (- (* R R) (* rho rho)) (* c rho))" by "(<= (- (* R R) (* rho rho)) (* 3.0 c rho))"
; mutant: replace "(<= (- R rho) (/ c 2.0))" by "(<= (- R rho) (/ c 4.0))"
(push 1)
(declare-const R Real)
(declare-const rho Real)
(declare-const c Real)
(assert (and (>= R 1.0) (>= rho 0.0) (> c 0.0)))
(assert (<= (- (* R R) (* rho rho)) (* c rho)))
(check-sat) ; expect sat
(assert (not (<= (- R rho) (/ c 2.0))))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_by_half_the_slope_and_a_little
; F <= c*rho outside the circle: it is c/2 + c^2/(8R) from there at most. (c = 1: 1/2 + 1/(8R); c = sqrt 2:
; sqrt(1/2) + 1/(4R).) Written with e = rho - R, and 8R times the bound.
; mutant: replace "(* c c)" by "0.0"
(push 1)
(declare-const R Real)
(declare-const e Real)
(declare-const c Real)
(assert (and (>= R 1.0) (>= e 0.0) (> c 0.0)))
(assert (<= (* e (+ (* 2.0 R) e)) (* c (+ R e))))
(check-sat) ; expect sat
(assert (not (<= (* 8.0 R e) (+ (* 4.0 R c) (* c c)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: one_pulse_outside
; F <= 2*rho - 1 is rho <= R + 1. (F < 2m is F <= 2m - 1, and m <= rho.)
; mutant: replace "(- (* 2.0 rho) 1.0)" by "(- (* 2.0 rho) 0.5)"
(push 1)
(declare-const R Real)
(declare-const rho Real)
(assert (and (>= R 1.0) (>= rho 0.0)))
(assert (<= (- (* rho rho) (* R R)) (- (* 2.0 rho) 1.0)))
(check-sat) ; expect sat
(assert (not (<= rho (+ R 1.0))))
(check-sat) ; expect unsat
(pop 1)

; lemma: coordinates_fit
; R <= 2^31 - 1 and a point within one pulse: no coordinate exceeds 2^31.
; mutant: replace "(+ R 1.0)" by "(+ R 1.5)"
(push 1)
(declare-const R Real)
(declare-const x Real)
(declare-const y Real)
(declare-const rho Real)
(assert (and (<= 0.0 x) (<= 0.0 y) (<= 0.0 rho) (<= R 2147483647.0)))
(assert (= (* rho rho) (+ (* x x) (* y y))))
(assert (<= rho (+ R 1.0)))
(check-sat) ; expect sat
(assert (not (<= x 2147483648.0)))
(check-sat) ; expect unsat
(pop 1)

; The arc by point-by-point comparison, in one quadrant.
;
;   t, a     the coordinate that is fed towards zero, and the one fed away from it: magnitudes
;   s        t^2 + a^2
;   R2, R    the radius squared, an integer, and the radius, a real number with R*R = R2
;   F        s - R2, the deviation function
;   p        the peak: the last column before an axis, t = 1, is left at a = p
;
; The rule: t - 1 if F >= 0, a + 1 if F < 0. The argument is in docs/proofs/ppc_arc.md. What is said
; of integers below is mostly true of real numbers too; then it is said of those.
(set-logic QF_NIRA)

; lemma: towards_pulse
; t - 1 changes F by -2t + 1.
; mutant: replace "(+ (- F (* 2 t)) 1)" by "(- (- F (* 2 t)) 1)"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const R2 Int)
(define-fun F () Int (- (+ (* t t) (* a a)) R2))
(check-sat) ; expect sat
(assert (not (= (- (+ (* (- t 1) (- t 1)) (* a a)) R2) (+ (- F (* 2 t)) 1))))
(check-sat) ; expect unsat
(pop 1)

; lemma: away_pulse
; a + 1 changes F by 2a + 1.
; mutant: replace "(+ F (* 2 a) 1)" by "(+ F (* 2 a))"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const R2 Int)
(define-fun F () Int (- (+ (* t t) (* a a)) R2))
(check-sat) ; expect sat
(assert (not (= (- (+ (* t t) (* (+ a 1) (+ a 1))) R2) (+ F (* 2 a) 1))))
(check-sat) ; expect unsat
(pop 1)

; lemma: edges_of_the_band
; (R-1)^2 <= s says R2+1-s <= 2R, and s <= (R+1)^2 says s-R2-1 <= 2R.
; mutant: replace "(<= (- s R2 1.0) (* 2.0 R))" by "(<= (- s R2) (* 2.0 R))"
; mutant: replace "(<= (- (+ R2 1.0) s) (* 2.0 R))" by "(< (- (+ R2 1.0) s) (* 2.0 R))"
(push 1)
(declare-const R Real)
(declare-const R2 Real)
(declare-const s Real)
(assert (= (* R R) R2))
(check-sat) ; expect sat
(assert (not (and (= (<= (* (- R 1.0) (- R 1.0)) s) (<= (- (+ R2 1.0) s) (* 2.0 R)))
                  (= (<= s (* (+ R 1.0) (+ R 1.0))) (<= (- s R2 1.0) (* 2.0 R))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: edges_in_integers
; For a whole number d, either of the two above, d <= 2R can be told without the root: d <= 0 or d^2 <= 4*R2.
; mutant: replace "(* 4.0 R R)" by "(* 2.0 R R)"
; mutant: replace "(<= d 0.0)" by "false"
; mutant: replace "(assert (>= R 1.0))" by ""
(push 1)
(declare-const R Real)
(declare-const d Real)
(assert (>= R 1.0))
(check-sat) ; expect sat
(assert (not (= (<= d (* 2.0 R)) (or (<= d 0.0) (<= (* d d) (* 4.0 R R))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: towards_pulse_far_out_stays_above_the_inner_edge
; t >= R: the new t alone is R - 1 or more. Below, t' = t - 1 and inner = R - 1.
; mutant: replace "(<= inner tafter)" by "(<= inner (+ tafter 1.0))"
; mutant: replace "(<= 0.0 inner)" by "true"
(push 1)
(declare-const inner Real)
(declare-const tafter Real)
(declare-const a Real)
(assert (<= 0.0 inner))
(assert (<= inner tafter))
(check-sat) ; expect sat
(assert (not (>= (+ (* tafter tafter) (* a a)) (* inner inner))))
(check-sat) ; expect unsat
(pop 1)

; lemma: towards_pulse_further_in_stays_above_the_inner_edge
; t < R and F >= 0: the pulse takes 2t - 1 < 2R - 1 from s >= R^2.
; mutant: replace "(>= (+ (* t t) (* a a)) (* R R))" by "(>= (+ (* t t) (* a a)) (- (* R R) 1.0))"
(push 1)
(declare-const R Real)
(declare-const t Real)
(declare-const a Real)
(assert (>= R 1.0))
(assert (< t R))
(assert (>= (+ (* t t) (* a a)) (* R R)))
(check-sat) ; expect sat
(assert (not (>= (+ (* (- t 1.0) (- t 1.0)) (* a a)) (* (- R 1.0) (- R 1.0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: towards_pulse_stays_below_the_outer_edge
; With t >= 1 the pulse does not increase s, so s <= (R+1)^2 goes on to hold.
; mutant: replace "(>= t 1.0)" by "(>= t 0.0)"
(push 1)
(declare-const t Real)
(declare-const a Real)
(declare-const edge Real)
(assert (>= t 1.0))
(assert (<= (+ (* t t) (* a a)) edge))
(check-sat) ; expect sat
(assert (not (<= (+ (* (- t 1.0) (- t 1.0)) (* a a)) edge)))
(check-sat) ; expect unsat
(pop 1)

; lemma: inside_the_circle_a_is_below_the_radius
; F < 0 gives a < R.
; mutant: replace "(< (+ (* t t) (* a a)) (* R R))" by "(<= (+ (* t t) (* a a)) (* R R))"
(push 1)
(declare-const R Real)
(declare-const t Real)
(declare-const a Real)
(assert (>= R 1.0))
(assert (< (+ (* t t) (* a a)) (* R R)))
(check-sat) ; expect sat
(assert (not (< a R)))
(check-sat) ; expect unsat
(pop 1)

; lemma: away_pulse_stays_below_the_outer_edge
; s < R^2 grows by 2a + 1 < 2R + 1.
; mutant: replace "(+ R 1.0) (+ R 1.0)" by "(+ R 0.5) (+ R 0.5)"
(push 1)
(declare-const R Real)
(declare-const t Real)
(declare-const a Real)
(assert (>= R 1.0))
(assert (< (+ (* t t) (* a a)) (* R R)))
(assert (< a R))
(check-sat) ; expect sat
(assert (not (<= (+ (* t t) (* (+ a 1.0) (+ a 1.0))) (* (+ R 1.0) (+ R 1.0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: away_pulse_stays_above_the_inner_edge
; With a >= 0 the pulse increases s, so (R-1)^2 <= s goes on to hold.
; mutant: replace "(>= a 0.0)" by "(>= a (- 1.0))"
(push 1)
(declare-const t Real)
(declare-const a Real)
(declare-const edge Real)
(assert (>= a 0.0))
(assert (>= (+ (* t t) (* a a)) edge))
(check-sat) ; expect sat
(assert (not (>= (+ (* t t) (* (+ a 1.0) (+ a 1.0))) edge)))
(check-sat) ; expect unsat
(pop 1)

; lemma: inner_edge_is_reached
; The bound is the best one: from (R,0), which is on the circle, the first pulse goes to (R-1,0).
; mutant: replace "(= t R)" by "(> t R)"
(push 1)
(declare-const R Real)
(declare-const t Real)
(declare-const a Real)
(assert (>= R 1.0))
(assert (= t R))
(assert (= a 0.0))
(check-sat) ; expect sat
(assert (not (= (+ (* (- t 1.0) (- t 1.0)) (* a a)) (* (- R 1.0) (- R 1.0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: points_of_the_circle_are_not_above_the_peak
; The coordinates of a point of the circle are p at most: (p + 1)^2 is p^2 + 3 or more, above R2. So the start is below
; the peak, and a quadrant entered at (p,0) is not entered past an end point in it.
; mutant: replace "(<= (- R2 1) (* p p))" by "(<= (- R2 9) (* p p))"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const p Int)
(declare-const R2 Int)
(assert (and (>= t 0) (>= a 0)))
(assert (= (+ (* t t) (* a a)) R2))
(assert (and (>= p 1) (< (* (- p 1) (- p 1)) (- R2 1)) (<= (- R2 1) (* p p))))
(check-sat) ; expect sat
(assert (not (<= a p)))
(check-sat) ; expect unsat
(pop 1)

; lemma: below_the_peak_while_inside
; F < 0 and t >= 1 give a < p: so a + 1 does not exceed the peak.
; mutant: replace "(>= t 1)" by "(>= t 0)"
; mutant: replace "(< (+ (* t t) (* a a)) R2)" by "(<= (+ (* t t) (* a a)) R2)"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const p Int)
(declare-const R2 Int)
(assert (and (>= t 1) (>= a 0)))
(assert (< (+ (* t t) (* a a)) R2))
(assert (and (>= p 1) (< (* (- p 1) (- p 1)) (- R2 1)) (<= (- R2 1) (* p p))))
(check-sat) ; expect sat
(assert (not (< a p)))
(check-sat) ; expect unsat
(pop 1)

; lemma: last_column_is_left_at_the_peak
; t = 1 and F >= 0 give a^2 >= R2 - 1 > (p-1)^2, so a >= p. As a never exceeds p, the axis is met at a = p exactly.
; Below, q = p - 1.
; mutant: replace "(> a q)" by "(> a (+ q 1))"
; mutant: replace "(= t 1)" by "(= t 2)"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const q Int)
(declare-const R2 Int)
(assert (and (= t 1) (>= a 0)))
(assert (>= (+ (* t t) (* a a)) R2))
(assert (and (>= q 0) (< (* q q) (- R2 1))))
(check-sat) ; expect sat
(assert (not (> a q)))
(check-sat) ; expect unsat
(pop 1)

; lemma: peak_is_a_coordinate
; On a circle within the coordinates, R2 <= M^2, the peak is a coordinate too: p <= M. (M is 2^31 - 1 in the machine.)
; mutant: replace "(<= R2 (* M M))" by "(<= R2 (+ (* M M) 2))"
(push 1)
(declare-const p Int)
(declare-const R2 Int)
(declare-const M Int)
(assert (>= M 1))
(assert (<= R2 (* M M)))
(assert (and (>= p 1) (< (* (- p 1) (- p 1)) (- R2 1)) (<= (- R2 1) (* p p))))
(check-sat) ; expect sat
(assert (not (<= p M)))
(check-sat) ; expect unsat
(pop 1)

; lemma: deviation_function_is_bounded_by_the_peak
; -2p < F <= 2p goes on to hold for every choice that the rule makes, so F has a register of two bits
; more than a coordinate.
; mutant: replace "(=> (< F 0) (< a p))" by "true"
; mutant: replace "(<= t p)" by "(<= t (+ p 1))"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const p Int)
(declare-const F Int)
(assert (and (<= 1 t) (<= t p) (<= 0 a)))
(assert (and (< (* (- 2) p) F) (<= F (* 2 p))))
(assert (=> (< F 0) (< a p)))
(define-fun after () Int (ite (>= F 0) (+ (- F (* 2 t)) 1) (+ F (* 2 a) 1)))
(check-sat) ; expect sat
(assert (not (and (< (* (- 2) p) after) (<= after (* 2 p)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: point_of_the_circle_is_not_passed_in_its_column
; Let (te,ae) be a point of the circle. In its column, t = te, below it, a < ae, F < 0: the rule goes
; on up to it.
; mutant: replace "(< a ae)" by "(<= a ae)"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const te Int)
(declare-const ae Int)
(declare-const R2 Int)
(assert (and (<= 0 te) (= te t) (<= 0 a) (< a ae)))
(assert (= (+ (* te te) (* ae ae)) R2))
(check-sat) ; expect sat
(assert (not (< (+ (* t t) (* a a)) R2)))
(check-sat) ; expect unsat
(pop 1)

; lemma: point_of_the_circle_is_not_passed_in_its_row
; In its row, a = ae, before it, t > te, F > 0: the rule goes on towards it.
; mutant: replace "(< te t)" by "(<= te t)"
(push 1)
(declare-const t Int)
(declare-const a Int)
(declare-const te Int)
(declare-const ae Int)
(declare-const R2 Int)
(assert (and (<= 0 te) (< te t) (<= 0 a) (= a ae)))
(assert (= (+ (* te te) (* ae ae)) R2))
(check-sat) ; expect sat
(assert (not (> (+ (* t t) (* a a)) R2)))
(check-sat) ; expect unsat
(pop 1)

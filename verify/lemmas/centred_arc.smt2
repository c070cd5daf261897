; The centred staggered circle, over real numbers: for registers of any width.
;
;   x, y     the point                             s = x^2 + y^2
;   m, h     the registers' modulus, and its half
;   a, b     JRx - h and JRy - h, so that -h <= a < h and -h <= b < h
;   turn     +1 counter-clockwise, -1 clockwise
;   p, q     the pulses of x and y, of a clock: -1, 0 or 1
;
; A clock adds -turn*y to a, a pulse p leaves when a leaves its range, x takes it; then turn*x is added to
; b, q leaves, y takes it. Each half of the clock is the same motion: a coordinate c with its register r
; and the integrand d that is added to it (d = -turn*y for x, d = turn*x for y).
;
;   Psi      m*s + 2*(a*x + b*y) - turn*x*y, which would be m*R^2 for ever if there were no pulses
;   N        what the pulses so far may have changed Psi by: |d| each
;
; The argument is in docs/proofs/centred_arc.md.
(set-logic QF_NRA)

; lemma: half_a_clock
; The terms of Psi with c change by p*(2r + d) - m*p^2. (-turn*x*y is d*c before the half of either axis,
; and -d*c after it.)
; mutant: replace "(- 0.0 (* d cafter))" by "(+ 0.0 (* d cafter))"
; mutant: replace "(* m p p)" by "(* 2.0 m p p)"
(push 1)
(declare-const m Real)
(declare-const c Real)
(declare-const r Real)
(declare-const d Real)
(declare-const p Real)
(define-fun cafter () Real (+ c p))
(define-fun rafter () Real (- (+ r d) (* m p)))
(define-fun before () Real (+ (* m c c) (* 2.0 r c) (* d c)))
(define-fun after () Real (+ (* m cafter cafter) (* 2.0 rafter cafter) (- 0.0 (* d cafter))))
(check-sat) ; expect sat
(assert (not (= (- after before) (- (* p (+ (* 2.0 r) d)) (* m p p)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: whole_clock
; Psi changes by p*(2a - turn*y) - m*p^2 + q*(2b + turn*x') - m*q^2, x' the new x: at pulses only.
; mutant: replace "(* turn xafter)" by "(* turn x)"
; mutant: replace "(- (* turn xafter yafter))" by "(* turn xafter yafter)"
(push 1)
(declare-const m Real)
(declare-const turn Real)
(declare-const x Real)
(declare-const y Real)
(declare-const a Real)
(declare-const b Real)
(declare-const p Real)
(declare-const q Real)
(define-fun xafter () Real (+ x p))
(define-fun yafter () Real (+ y q))
(define-fun dy () Real (* turn xafter))
(define-fun aafter () Real (- a (* turn y) (* m p)))
(define-fun bafter () Real (- (+ b dy) (* m q)))
(define-fun before () Real
  (+ (* m (+ (* x x) (* y y))) (* 2.0 (+ (* a x) (* b y))) (- (* turn x y))))
(define-fun after () Real
  (+ (* m (+ (* xafter xafter) (* yafter yafter))) (* 2.0 (+ (* aafter xafter) (* bafter yafter)))
     (- (* turn xafter yafter))))
(check-sat) ; expect sat
(assert (not (= (- after before)
                (+ (- (* p (- (* 2.0 a) (* turn y))) (* m p p))
                   (- (* q (+ (* 2.0 b) dy)) (* m q q))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: clockwise_is_the_mirror_image_but_for_a_tie
; The clockwise machine subtracts x from b where the mirrored one adds it to -b: the same pulse, mirrored,
; unless the sum is h or -h exactly. (At -h the one makes no pulse, as the range is open on one side only,
; and the other makes one.) So the sense is carried as a sign here, and no lemma uses the mirror.
; mutant: replace "(distinct (- b x) (- h))" by "true"
; mutant: replace "(distinct (- b x) h)" by "true"
(push 1)
(declare-const h Real)
(declare-const b Real)
(declare-const x Real)
(assert (and (<= (- h) b) (< b h)))
(assert (distinct (- b x) (- h)))
(assert (distinct (- b x) h))
(define-fun q () Real (ite (>= (- b x) h) 1.0 (ite (< (- b x) (- h)) (- 1.0) 0.0)))
(define-fun mirrored () Real (ite (>= (- x b) h) 1.0 (ite (< (- x b) (- h)) (- 1.0) 0.0)))
(check-sat) ; expect sat
(assert (not (= q (- mirrored))))
(check-sat) ; expect unsat
(pop 1)

; lemma: remainder_stays_in_its_register
; One pulse brings a remainder back into its range, as |d| <= h.
; mutant: replace "(<= d h)" by "(<= d (* 3.0 h))"
; mutant: replace "(< r h)" by "(<= r h)"
(push 1)
(declare-const h Real)
(declare-const r Real)
(declare-const d Real)
(assert (and (<= (- h) r) (< r h)))
(assert (and (<= (- h) d) (<= d h)))
(define-fun p () Real (ite (>= (+ r d) h) 1.0 (ite (< (+ r d) (- h)) (- 1.0) 0.0)))
(define-fun rafter () Real (- (+ r d) (* 2.0 h p)))
(check-sat) ; expect sat
(assert (not (and (<= (- h) rafter) (< rafter h))))
(check-sat) ; expect unsat
(pop 1)

; lemma: pulse_has_the_sign_of_its_integrand
; So in a quadrant one coordinate falls in magnitude and the other one grows: with the sense
; counter-clockwise x moves against y's sign, and y with x's.
; mutant: replace "(> d 0.0)" by "(> d 1.0)"
; mutant: replace "(< d 0.0)" by "(> d 0.0)"
(push 1)
(declare-const h Real)
(declare-const r Real)
(declare-const d Real)
(assert (and (<= (- h) r) (< r h)))
(define-fun p () Real (ite (>= (+ r d) h) 1.0 (ite (< (+ r d) (- h)) (- 1.0) 0.0)))
(check-sat) ; expect sat
(assert (not (and (=> (= p 1.0) (> d 0.0)) (=> (= p (- 1.0)) (< d 0.0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: pulse_changes_psi_by_its_integrand_at_most
; |p*(2r + d) - m*p^2| <= |d|: r was on one side of the range's edge, r + d is on the other side, so that
; the edge's double, m, is within |d| of the sum of both.
; mutant: replace "(+ (* 2.0 r) d)" by "(* 2.0 r)"
; mutant: replace "(<= (- h) r)" by "true"
; mutant: replace "(< r h)" by "true"
(push 1)
(declare-const h Real)
(declare-const r Real)
(declare-const d Real)
(assert (and (<= (- h) r) (< r h)))
(define-fun p () Real (ite (>= (+ r d) h) 1.0 (ite (< (+ r d) (- h)) (- 1.0) 0.0)))
(define-fun size () Real (ite (>= d 0.0) d (- d)))
(define-fun change () Real (- (* p (+ (* 2.0 r) d)) (* 2.0 h p p)))
(check-sat) ; expect sat
(assert (not (and (<= (- size) change) (<= change size) (=> (= p 0.0) (= change 0.0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: start
; The preset makes 2*a0 = turn*y0 + e, where e is 0 or what rounding took, |e| <= 1; b0 = 0. Then Psi is
; m*R2 but for e*x0, hence |Psi - m*R2| <= |x0|.
; mutant: replace "(<= e 1.0)" by "(<= e 2.0)"
; mutant: replace "(+ (* turn y0) e)" by "(- e (* turn y0))"
(push 1)
(declare-const m Real)
(declare-const turn Real)
(declare-const x0 Real)
(declare-const y0 Real)
(declare-const e Real)
(assert (and (<= (- 1.0) e) (<= e 1.0)))
(define-fun R2 () Real (+ (* x0 x0) (* y0 y0)))
; Twice a0.
(define-fun aa () Real (+ (* turn y0) e))
(define-fun psi () Real (- (+ (* m R2) (* aa x0)) (* turn x0 y0)))
(define-fun size () Real (ite (>= x0 0.0) x0 (- x0)))
(check-sat) ; expect sat
(assert (not (and (<= (- size) (- psi (* m R2))) (<= (- psi (* m R2)) size))))
(check-sat) ; expect unsat
(pop 1)

; lemma: budget
; |Psi - m*R2| <= N + |x0| goes on to hold when a pulse changes Psi by |d| at most and |d| is added to N.
; mutant: replace "(+ N size)" by "N"
; mutant: replace "(<= change size)" by "true"
(push 1)
(declare-const off Real) ; Psi - m*R2
(declare-const N Real)
(declare-const x0 Real)
(declare-const change Real)
(declare-const size Real)
(assert (and (<= (- (+ N x0)) off) (<= off (+ N x0))))
(assert (<= (- size) change))
(assert (<= change size))
(define-fun Nafter () Real (+ N size))
(check-sat) ; expect sat
(assert (not (and (<= (- (+ Nafter x0)) (+ off change)) (<= (+ off change) (+ Nafter x0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: area_at_a_pulse_towards
; In one quadrant let t be the magnitude that falls and a the one that grows, (t1,a1) where the quadrant was
; entered, with N = Ns, and B a bound on all coordinates met. Then N <= Ns + t*a - t1*a1 + 2B*(t1 - t): it goes
; on to hold when t falls by one and N grows by a, since a <= B.
; mutant: replace "(<= a B)" by "(<= a (+ B 1.0))"
; mutant: replace "(+ N a)" by "(+ N a 1.0)"
(push 1)
(declare-const B Real)
(declare-const N Real)
(declare-const Ns Real)
(declare-const t Real)
(declare-const a Real)
(declare-const t1 Real)
(declare-const a1 Real)
(assert (<= a B))
(assert (<= N (+ Ns (* t a) (- (* t1 a1)) (* 2.0 B (- t1 t)))))
(define-fun tafter () Real (- t 1.0))
(check-sat) ; expect sat
(assert (not (<= (+ N a) (+ Ns (* tafter a) (- (* t1 a1)) (* 2.0 B (- t1 tafter))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: area_at_a_pulse_away
; The same when a grows by one and N by t: t*a grows by t too.
; mutant: replace "(+ N t)" by "(+ N t 1.0)"
(push 1)
(declare-const B Real)
(declare-const N Real)
(declare-const Ns Real)
(declare-const t Real)
(declare-const a Real)
(declare-const t1 Real)
(declare-const a1 Real)
(assert (<= N (+ Ns (* t a) (- (* t1 a1)) (* 2.0 B (- t1 t)))))
(define-fun aafter () Real (+ a 1.0))
(check-sat) ; expect sat
(assert (not (<= (+ N t) (+ Ns (* t aafter) (- (* t1 a1)) (* 2.0 B (- t1 t))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: area_of_a_quadrant
; At any point of a quadrant N - Ns <= 2*B^2, wherever it was entered: t*a <= B*t, so that the two terms with t
; together are at most 2B*t1.
; mutant: replace "(<= t1 B)" by "true"
; mutant: replace "(<= a B)" by "(<= a (* 3.0 B))"
(push 1)
(declare-const B Real)
(declare-const N Real)
(declare-const Ns Real)
(declare-const t Real)
(declare-const a Real)
(declare-const t1 Real)
(declare-const a1 Real)
(assert (and (<= 0.0 t) (<= 0.0 a) (<= 0.0 a1) (<= 0.0 t1)))
(assert (<= a B))
(assert (<= t1 B))
(assert (<= N (+ Ns (* t a) (- (* t1 a1)) (* 2.0 B (- t1 t)))))
(check-sat) ; expect sat
(assert (not (<= N (+ Ns (* 2.0 B B)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: area_with_three_crossings
; Three crossings or fewer make four quadrants or fewer, of 2*B^2 each at most: N <= 8*B^2.
; mutant: replace "(<= N4 (+ N3 (* 2.0 B B)))" by "(<= N4 (+ N3 (* 3.0 B B)))"
(push 1)
(declare-const B Real)
(declare-const N1 Real)
(declare-const N2 Real)
(declare-const N3 Real)
(declare-const N4 Real)
(assert (<= N1 (* 2.0 B B)))
(assert (<= N2 (+ N1 (* 2.0 B B))))
(assert (<= N3 (+ N2 (* 2.0 B B))))
(assert (<= N4 (+ N3 (* 2.0 B B))))
(check-sat) ; expect sat
(assert (not (<= N4 (* 8.0 B B))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_is_not_beyond_the_start
; A full turn from (t0,a0) inside a quadrant crosses four axes and ends in that quadrant, at or before the start's
; direction: a/t <= a0/t0, or t0*a <= t*a0, at the point (t,a), the last one before an axis stands or any earlier one.
; Then t0^2*(t^2 + a^2) <= t^2*(t0^2 + a0^2): it has the larger share of its radius in t. Below, u = t0*a and v = t*a0.
; mutant: replace "(<= u v)" by "true"
; mutant: replace "(<= 0.0 u)" by "true"
(push 1)
(declare-const t0 Real)
(declare-const t Real)
(declare-const a Real)
(declare-const a0 Real)
(declare-const u Real)
(declare-const v Real)
(assert (= u (* t0 a)))
(assert (= v (* t a0)))
(assert (<= 0.0 u))
(assert (<= u v))
(check-sat) ; expect sat
(assert (not (<= (+ (* t0 t0 t t) (* u u)) (+ (* t t t0 t0) (* v v)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_has_the_start_s_share
; With t^2 + a^2 >= q^2 and t0^2 + a0^2 = r^2 that is t0^2*q^2 <= t^2*r^2, so t0*q <= t*r.
; mutant: replace "(<= (* t0 t0 q q) (* t t r r))" by "true"
; mutant: replace "(<= 0.0 r)" by "true"
(push 1)
(declare-const r Real)
(declare-const q Real)
(declare-const t0 Real)
(declare-const t Real)
(assert (and (<= 0.0 t0) (<= 0.0 t) (<= 0.0 q)))
(assert (<= 0.0 r))
(assert (<= (* t0 t0 q q) (* t t r r)))
(check-sat) ; expect sat
(assert (not (<= (* t0 q) (* t r))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_is_not_far_from_the_start
; A point within one pulse of the circle has q = r - 1, which makes t >= t0 - 1.
; mutant: replace "(<= t0 r)" by "true"
; mutant: replace "(- t0 1.0)" by "(- t0 0.9)"
(push 1)
(declare-const r Real)
(declare-const t0 Real)
(declare-const t Real)
(assert (and (<= 0.0 t0) (<= 0.0 t) (< 0.0 r)))
(assert (<= t0 r))
(assert (>= (* t r) (* t0 (- r 1.0))))
(check-sat) ; expect sat
(assert (not (>= t (- t0 1.0))))
(check-sat) ; expect unsat
(pop 1)

; lemma: last_part_below_the_start
; The first part of such a turn costs t0*(2B - a0) at most. The last part is entered on its axis at t1 <= B and costs
; t*a + 2B*(t1 - t), which is 2B*t1 - t*(2B - a). Where a <= a0, the one is 2B at most above what the other saves.
; mutant: replace "(<= a a0)" by "(<= a B)"
; mutant: replace "(>= t (- t0 1.0))" by "(>= t (- t0 2.0))"
(push 1)
(declare-const B Real)
(declare-const t0 Real)
(declare-const a0 Real)
(declare-const t Real)
(declare-const a Real)
(assert (and (<= 0.0 t0) (<= 0.0 a0) (<= a0 B) (<= 0.0 a) (<= 0.0 t)))
(assert (<= a a0))
(assert (>= t (- t0 1.0)))
(check-sat) ; expect sat
(assert (not (<= (- (* t0 (- (* 2.0 B) a0)) (* t (- (* 2.0 B) a))) (* 2.0 B))))
(check-sat) ; expect unsat
(pop 1)

; lemma: shares_grow_up_to_the_bound
; a*(2B - a) grows up to a = B.
; mutant: replace "(<= a B)" by "(<= a (* 3.0 B))"
; mutant: replace "(<= a0 a)" by "true"
(push 1)
(declare-const B Real)
(declare-const a0 Real)
(declare-const a Real)
(assert (<= 0.0 a0))
(assert (<= a0 a))
(assert (<= a B))
(check-sat) ; expect sat
(assert (not (<= (* a0 (- (* 2.0 B) a0)) (* a (- (* 2.0 B) a)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: last_part_above_the_start
; Where a > a0 (the end is off the circle then) t is above t0 in the same proportion, and the last part saves more than
; the first part costs: a0 times the one is at least a0 times the other. Below, w = 2B - a and w0 = 2B - a0; the lemma
; before says a0*w0 <= a*w. (a0 > 0: with a0 = 0 nothing lies before the start's direction.)
; mutant: replace "(<= (* a0 w0) (* a w))" by "true"
; mutant: replace "(<= (* t0 a) (* t a0))" by "true"
(push 1)
(declare-const t0 Real)
(declare-const a0 Real)
(declare-const t Real)
(declare-const a Real)
(declare-const w0 Real)
(declare-const w Real)
(assert (and (<= 0.0 t0) (<= 0.0 w)))
(assert (<= (* a0 w0) (* a w)))
(assert (<= (* t0 a) (* t a0)))
(check-sat) ; expect sat
(assert (not (<= (* t0 a0 w0) (* t a0 w))))
(check-sat) ; expect unsat
(pop 1)

; lemma: common_factor
; And without the factor a0: firstpart = t0*w0 is at most saved = t*w.
; mutant: replace "(< 0.0 a0)" by "(<= 0.0 a0)"
(push 1)
(declare-const a0 Real)
(declare-const firstpart Real)
(declare-const saved Real)
(assert (< 0.0 a0))
(assert (<= (* a0 firstpart) (* a0 saved)))
(check-sat) ; expect sat
(assert (not (<= firstpart saved)))
(check-sat) ; expect unsat
(pop 1)

; lemma: area_of_a_full_turn
; With three whole quadrants between the two parts, N <= 8*B^2 + 2*B.
; mutant: replace "(* 6.0 B B)" by "(* 7.0 B B)"
; mutant: replace "(<= t1 B)" by "true"
(push 1)
(declare-const B Real)
(declare-const N Real)
(declare-const firstpart Real)
(declare-const saved Real) ; t*(2B - a)
(declare-const t1 Real)
(assert (<= 0.0 t1))
(assert (<= t1 B))
(assert (<= (- firstpart saved) (* 2.0 B)))
(assert (<= N (+ firstpart (* 6.0 B B) (- (* 2.0 B t1) saved))))
(check-sat) ; expect sat
(assert (not (<= N (+ (* 8.0 B B) (* 2.0 B)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: area_after_one_more_pulse
; The areas are those of points within a pulse of the circle. The next pulse, of which that is still to be shown, adds
; the coordinate that it does not change, B at most: N <= 8*B^2 + 3*B after it.
; mutant: replace "(<= size B)" by "(<= size (+ B 1.0))"
(push 1)
(declare-const B Real)
(declare-const N Real)
(declare-const size Real)
(assert (<= 0.0 B))
(assert (<= N (+ (* 8.0 B B) (* 2.0 B))))
(assert (<= size B))
(check-sat) ; expect sat
(assert (not (<= (+ N size) (+ (* 8.0 B B) (* 3.0 B)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: register_times_coordinate
; |2*r*c| <= m*|c|, as a register is within half the modulus of its middle.
; mutant: replace "(<= r h)" by "(<= r (* 2.0 h))"
(push 1)
(declare-const h Real)
(declare-const r Real)
(declare-const c Real)
(define-fun size () Real (ite (>= c 0.0) c (- c)))
(assert (<= (- h) r))
(assert (<= r h))
(check-sat) ; expect sat
(assert (not (and (<= (- (* 2.0 h size)) (* 2.0 r c)) (<= (* 2.0 r c) (* 2.0 h size)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: deviation
; Psi = m*s + 2*(a*x + b*y) - turn*x*y and |Psi - m*R2| <= N + |x0| give
; |m*s - m*R2| <= m*(|x| + |y|) + |x*y| + N + |x0|. Below, ms is m*s and so on; every product is bounded by the
; lemma before. (After the first half of a clock the last term is +turn*x*y: its size is the same.)
; mutant: replace "(<= by my)" by "(<= by (* 2.0 my))"
; mutant: replace "(+ N x0)) (- psi mR2)" by "(* 2.0 (+ N x0))) (- psi mR2)"
; mutant: replace "(<= xy uv)" by "true"
(push 1)
(declare-const ms Real)
(declare-const mR2 Real)
(declare-const psi Real)
(declare-const N Real)
(declare-const x0 Real)
(declare-const ax Real) ; 2*a*x
(declare-const by Real) ; 2*b*y
(declare-const xy Real) ; turn*x*y
(declare-const mx Real) ; m*|x|
(declare-const my Real) ; m*|y|
(declare-const uv Real) ; |x*y|
(assert (= psi (- (+ ms ax by) xy)))
(assert (and (<= (- (+ N x0)) (- psi mR2)) (<= (- psi mR2) (+ N x0))))
(assert (and (<= (- mx) ax) (<= ax mx)))
(assert (and (<= (- my) by) (<= by my)))
(assert (and (<= (- uv) xy) (<= xy uv)))
(check-sat) ; expect sat
(assert (not (and (<= (- mR2 ms) (+ mx my uv N x0)) (<= (- ms mR2) (+ mx my uv N x0)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: product_of_the_coordinates
; 2*u*v <= u^2 + v^2 = rho^2, where u = |x| and v = |y|; u is written as v and what it is more.
; mutant: replace "(* 2.0 u v)" by "(* 2.1 u v)"
(push 1)
(declare-const v Real)
(declare-const more Real)
(define-fun u () Real (+ v more))
(check-sat) ; expect sat
(assert (not (<= (* 2.0 u v) (+ (* u u) (* v v)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: sum_of_the_coordinates
; u + v <= 1.41422*rho: the square root of two, rounded up.
; mutant: replace "1.41422" by "1.41421"
(push 1)
(declare-const u Real)
(declare-const v Real)
(declare-const rho Real)
(assert (and (<= 0.0 u) (<= 0.0 v) (<= 0.0 rho)))
(assert (= (* rho rho) (+ (* u u) (* v v))))
(assert (<= (* 2.0 u v) (* rho rho)))
(check-sat) ; expect sat
(assert (not (<= (+ u v) (* 1.41422 rho))))
(check-sat) ; expect unsat
(pop 1)

; lemma: integrands_fit
; Within one pulse of the circle every coordinate, r + 1 at most, is below half the modulus.
; mutant: replace "(<= (* 16.0 r) m)" by "(<= (* 2.0 r) m)"
(push 1)
(declare-const m Real)
(declare-const r Real)
(assert (>= r 1.0))
(assert (<= (* 16.0 r) m))
(check-sat) ; expect sat
(assert (not (< (* 2.0 (+ r 1.0)) m)))
(check-sat) ; expect unsat
(pop 1)

; lemma: wider_registers_are_better
; What a deviation of d = |rho^2 - r^2| - 1.41422*rho needs of the budget, m*d, is more than the budget for
; every m >= k*r if it is for m = k*r: as the budget is positive, so is d.
; mutant: replace "(<= (* k r) m)" by "true"
; mutant: replace "(<= 0.0 rest)" by "true"
(push 1)
(declare-const k Real)
(declare-const m Real)
(declare-const r Real)
(declare-const d Real)
(declare-const rest Real)
(assert (and (< 0.0 k) (< 0.0 r)))
(assert (<= 0.0 rest))
(assert (<= (* k r) m))
(assert (> (* k r d) rest))
(check-sat) ; expect sat
(assert (not (> (* m d) rest)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_outside_by_more_than_a_pulse_16
; For m = 16*r and r >= 32.08, which is R2 >= 1030: with B <= r + 1, N <= 8*B^2 + 3*B and |x0| <= r the budget is not
; enough for a point beyond one pulse outside: m*(rho^2 - r^2 - 1.41422*rho) is more than rho^2/2 + N + |x0|.
; mutant: replace "(>= r 32.08)" by "(>= r 32.07)"
; mutant: replace "(> rho (+ r 1.0))" by "(> rho (+ r 0.9))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 32.08))
(assert (> rho (+ r 1.0)))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 16.0 r (- (* rho rho) (* r r) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_inside_by_more_than_a_pulse_16
; Nor for a point beyond one pulse inside.
; mutant: replace "(< rho (- r 1.0))" by "(< rho (+ r 0.5))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 32.08))
(assert (and (<= 0.0 rho) (< rho (- r 1.0))))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 16.0 r (- (* r r) (* rho rho) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_outside_by_more_than_a_pulse_32
; The same for m = 32*r and r >= 3.7, which is R2 >= 14.
; mutant: replace "(>= r 3.7)" by "(>= r 3.6)"
; mutant: replace "(> rho (+ r 1.0))" by "(> rho (+ r 0.9))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 3.7))
(assert (> rho (+ r 1.0)))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 32.0 r (- (* rho rho) (* r r) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_inside_by_more_than_a_pulse_32
; The same for m = 32*r and r >= 3.7, which is R2 >= 14.
; mutant: replace "(< rho (- r 1.0))" by "(< rho (+ r 0.5))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 3.7))
(assert (and (<= 0.0 rho) (< rho (- r 1.0))))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 32.0 r (- (* r r) (* rho rho) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_outside_by_more_than_a_pulse_64
; The same for m = 64*r and r >= 2, which is R2 >= 4.
; mutant: replace "(>= r 2.0)" by "(>= r 1.7)"
; mutant: replace "(> rho (+ r 1.0))" by "(> rho (+ r 0.9))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 2.0))
(assert (> rho (+ r 1.0)))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 64.0 r (- (* rho rho) (* r r) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_inside_by_more_than_a_pulse_64
; The same for m = 64*r and r >= 2, which is R2 >= 4.
; mutant: replace "(< rho (- r 1.0))" by "(< rho (+ r 0.5))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 2.0))
(assert (and (<= 0.0 rho) (< rho (- r 1.0))))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 64.0 r (- (* r r) (* rho rho) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_outside_by_more_than_a_pulse_128
; The same for m = 128*r and r >= 1.41, which is R2 >= 2.
; mutant: replace "(>= r 1.41)" by "(>= r 1.0)"
; mutant: replace "(> rho (+ r 1.0))" by "(> rho (+ r 0.9))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 1.41))
(assert (> rho (+ r 1.0)))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 128.0 r (- (* rho rho) (* r r) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_inside_by_more_than_a_pulse_128
; The same for m = 128*r and r >= 1.41, which is R2 >= 2.
; mutant: replace "(< rho (- r 1.0))" by "(< rho (+ r 0.5))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 1.41))
(assert (and (<= 0.0 rho) (< rho (- r 1.0))))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 128.0 r (- (* r r) (* rho rho) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_outside_by_more_than_a_pulse_256
; The same for m = 256*r and r >= 1, which is R2 >= 1.
; mutant: replace "(>= r 1.0)" by "(>= r 0.9)"
; mutant: replace "(> rho (+ r 1.0))" by "(> rho (+ r 0.9))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 1.0))
(assert (> rho (+ r 1.0)))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 256.0 r (- (* rho rho) (* r r) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: not_inside_by_more_than_a_pulse_256
; The same for m = 256*r and r >= 1, which is R2 >= 1.
; mutant: replace "(< rho (- r 1.0))" by "(< rho (+ r 0.5))"
(push 1)
(declare-const r Real)
(declare-const rho Real)
(assert (>= r 1.0))
(assert (and (<= 0.0 rho) (< rho (- r 1.0))))
(define-fun B () Real (+ r 1.0))
(define-fun budget () Real (+ (* 0.5 rho rho) (* 8.0 B B) (* 3.0 B) r))
(check-sat) ; expect sat
(assert (not (> (* 256.0 r (- (* r r) (* rho rho) (* 1.41422 rho))) budget)))
(check-sat) ; expect unsat
(pop 1)

; lemma: last_quadrant_is_not_entered_past_the_end
; A quadrant is entered on its axis at (t1,0), t1 >= R - 1 and whole, and a point (te,ae) of the circle with
; ae >= 1 has te < R. So te < t1 + 1, which is te <= t1 for whole numbers.
; mutant: replace "(>= ae 1.0)" by "(>= ae 0.0)"
; mutant: replace "(- r 1.0)" by "(- r 1.1)"
(push 1)
(declare-const r Real)
(declare-const te Real)
(declare-const ae Real)
(declare-const t1 Real)
(assert (and (>= r 1.0) (>= te 0.0) (>= ae 1.0)))
(assert (= (+ (* te te) (* ae ae)) (* r r)))
(assert (>= t1 (- r 1.0)))
(check-sat) ; expect sat
(assert (not (< te (+ t1 1.0))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_in_its_column
; t stands at te, and a < ae grows towards the point (te,ae) of the circle: from inside, no further out than it.
; mutant: replace "(<= (+ a 1.0) ae)" by "(<= a ae)"
; mutant: replace "(<= 0.0 a)" by "true"
(push 1)
(declare-const R2 Real)
(declare-const te Real)
(declare-const ae Real)
(declare-const a Real)
(assert (<= 0.0 a))
(assert (<= (+ a 1.0) ae))
(assert (= (+ (* te te) (* ae ae)) R2))
(define-fun before () Real (+ (* te te) (* a a)))
(define-fun after () Real (+ (* te te) (* (+ a 1.0) (+ a 1.0))))
(check-sat) ; expect sat
(assert (not (and (<= before after) (<= after R2))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_in_its_row
; a stands at ae, and t > te falls to t' >= te, towards the point of the circle: from outside, no further in than it.
; mutant: replace "(<= te tafter)" by "true"
; mutant: replace "(<= 0.0 te)" by "true"
(push 1)
(declare-const R2 Real)
(declare-const te Real)
(declare-const ae Real)
(declare-const tafter Real)
(assert (<= 0.0 te))
(assert (<= te tafter))
(assert (= (+ (* te te) (* ae ae)) R2))
(define-fun t () Real (+ tafter 1.0))
(define-fun before () Real (+ (* t t) (* ae ae)))
(define-fun after () Real (+ (* tafter tafter) (* ae ae)))
(check-sat) ; expect sat
(assert (not (and (>= before after) (>= after R2))))
(check-sat) ; expect unsat
(pop 1)

; lemma: a_pulse_within_m_clocks
; As long as an axis makes no pulse and its integrand stays the same d, its register goes on by d a clock within
; its range: fewer than m clocks if |d| >= 1. So a path that is not at its end goes on.
; mutant: replace "(or (>= d 1.0) (<= d (- 1.0)))" by "true"
(push 1)
(declare-const h Real)
(declare-const r Real)
(declare-const d Real)
(declare-const clocks Real)
(assert (>= clocks 0.0))
(assert (or (>= d 1.0) (<= d (- 1.0))))
(assert (and (<= (- h) r) (< r h)))
(assert (and (<= (- h) (+ r (* clocks d))) (< (+ r (* clocks d)) h)))
(check-sat) ; expect sat
(assert (not (< clocks (* 2.0 h))))
(check-sat) ; expect unsat
(pop 1)

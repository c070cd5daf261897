; The parabola v^2 = 2*P*u by digital integration, over real numbers: for registers of any width.
;
;   P        the parameter's magnitude
;   u, v     the point, along the axis of symmetry and across it: magnitudes
;   m, h     the registers' modulus, and its half
;   a, b     the remainders across and along, less h: -h <= a <= h - 1 and -h <= b <= h - 1
;   b0       what b was at the vertex
;   p, q     the pulses across and along, of a clock: 0 or 1
;
;   F        v^2 - 2*P*u, the deviation function
;   Phi      m*v^2 + 2*a*v - 2*P*(m*u + b), which changes at pulses across only
;   grown    Phi less what it was at the vertex
;
;   s2       P^2 + v^2, of which 2*sqrt(s2) is F's gradient
;   small    the smaller one of P and v, and `large` the other one
;   room     m, m/2 or m/4, by the headroom bits: neither P nor v is above it
;   k        room/m
;
; The argument is in docs/proofs/parabola_dda.md.
(set-logic QF_NRA)

; lemma: clock_changes_phi
; A clock changes Phi by p*(2(a + P) - m), with a before it, whether there is a pulse along or not.
; mutant: replace "(- (+ b v) (* m q))" by "(- (+ b vafter) (* m q))"
; mutant: replace "(* 2.0 (+ a P))" by "(* 2.0 a)"
(push 1)
(declare-const m Real)
(declare-const P Real)
(declare-const u Real)
(declare-const v Real)
(declare-const a Real)
(declare-const b Real)
(declare-const p Real)
(declare-const q Real)
(assert (or (= p 0.0) (= p 1.0)))
(define-fun uafter () Real (+ u q))
(define-fun vafter () Real (+ v p))
(define-fun aafter () Real (- (+ a P) (* m p)))
(define-fun bafter () Real (- (+ b v) (* m q)))
(define-fun before () Real (- (+ (* m v v) (* 2.0 a v)) (* 2.0 P (+ (* m u) b))))
(define-fun after () Real
  (- (+ (* m vafter vafter) (* 2.0 aafter vafter)) (* 2.0 P (+ (* m uafter) bafter))))
(check-sat) ; expect sat
(assert (not (= (- after before) (* p (- (* 2.0 (+ a P)) m)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: pulse_across_adds_less_than_twice_the_parameter
; A pulse comes if a + P is at h or above, and a is below h: 0 <= 2(a + P) - m <= 2(P - 1).
; mutant: replace "(<= a (- h 1.0))" by "(<= a h)"
; mutant: replace "(>= (+ a P) h)" by "(>= (+ a P) (- h 1.0))"
(push 1)
(declare-const h Real)
(declare-const P Real)
(declare-const a Real)
(assert (<= a (- h 1.0)))
(define-fun m () Real (* 2.0 h))
(define-fun p () Real (ite (>= (+ a P) h) 1.0 0.0))
(define-fun change () Real (* p (- (* 2.0 (+ a P)) m)))
(assert (>= P 1.0))
(check-sat) ; expect sat
(assert (not (and (<= 0.0 change) (<= change (* 2.0 (- P 1.0) p)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: phi_grows_with_the_way_across
; 0 <= grown <= 2(P - 1)*v goes on to hold.
; mutant: replace "(<= change (* 2.0 (- P 1.0) p))" by "(<= change (* 2.0 P p))"
; mutant: replace "(<= 0.0 change)" by "true"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const p Real)
(declare-const grown Real)
(declare-const change Real)
(assert (and (<= 0.0 grown) (<= grown (* 2.0 (- P 1.0) v))))
(assert (and (<= 0.0 change) (<= change (* 2.0 (- P 1.0) p))))
(check-sat) ; expect sat
(assert (not (and (<= 0.0 (+ grown change)) (<= (+ grown change) (* 2.0 (- P 1.0) (+ v p))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: deviation_function_from_phi
; m*F = grown - 2*a*v + 2*P*(b - b0): at the vertex Phi was -2*P*b0.
; mutant: replace "(- b b0)" by "(+ b b0)"
(push 1)
(declare-const m Real)
(declare-const P Real)
(declare-const u Real)
(declare-const v Real)
(declare-const a Real)
(declare-const b Real)
(declare-const b0 Real)
(define-fun F () Real (- (* v v) (* 2.0 P u)))
(define-fun Phi () Real (- (+ (* m v v) (* 2.0 a v)) (* 2.0 P (+ (* m u) b))))
(define-fun grown () Real (- Phi (- (* 2.0 P b0))))
(check-sat) ; expect sat
(assert (not (= (* m F) (+ (- grown (* 2.0 a v)) (* 2.0 P (- b b0))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: remainder_across
; The first remainder's share: -(m - 2)*v <= -2*a*v <= m*v.
; mutant: replace "(<= (- h) a)" by "(<= (- (- h) 1.0) a)"
; mutant: replace "(<= a (- h 1.0))" by "(<= a h)"
(push 1)
(declare-const h Real)
(declare-const v Real)
(declare-const a Real)
(define-fun m () Real (* 2.0 h))
(assert (>= v 0.0))
(assert (<= (- h) a))
(assert (<= a (- h 1.0)))
(check-sat) ; expect sat
(assert (not (and (<= (- (* (- m 2.0) v)) (- (* 2.0 a v))) (<= (- (* 2.0 a v)) (* m v)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: remainder_along_with_half_load
; The second one's, from b0 = 0: -m*P <= 2*P*(b - b0) <= (m - 2)*P.
; mutant: replace "(= b0 0.0)" by "(= b0 1.0)"
; mutant: replace "(= b0 0.0)" by "(= b0 (- 1.0))"
(push 1)
(declare-const h Real)
(declare-const P Real)
(declare-const b Real)
(declare-const b0 Real)
(define-fun m () Real (* 2.0 h))
(assert (>= P 1.0))
(assert (and (<= (- h) b) (<= b (- h 1.0))))
(assert (= b0 0.0))
(check-sat) ; expect sat
(assert (not (and (<= (- (* m P)) (* 2.0 P (- b b0))) (<= (* 2.0 P (- b b0)) (* (- m 2.0) P)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: remainder_along_without_load
; From b0 = -h: 0 <= 2*P*(b - b0) <= 2*(m - 1)*P.
; mutant: replace "(= b0 (- h))" by "(= b0 0.0)"
; mutant: replace "(<= b (- h 1.0))" by "(<= b h)"
(push 1)
(declare-const h Real)
(declare-const P Real)
(declare-const b Real)
(declare-const b0 Real)
(define-fun m () Real (* 2.0 h))
(assert (>= P 1.0))
(assert (<= (- h) b))
(assert (<= b (- h 1.0)))
(assert (= b0 (- h)))
(check-sat) ; expect sat
(assert (not (and (<= 0.0 (* 2.0 P (- b b0))) (<= (* 2.0 P (- b b0)) (* 2.0 (- m 1.0) P)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: remainder_along_with_full_load
; From b0 = h - 1: -2*(m - 1)*P <= 2*P*(b - b0) <= 0.
; mutant: replace "(= b0 (- h 1.0))" by "(= b0 0.0)"
; mutant: replace "(<= (- h) b)" by "(<= (- (- h) 1.0) b)"
(push 1)
(declare-const h Real)
(declare-const P Real)
(declare-const b Real)
(declare-const b0 Real)
(define-fun m () Real (* 2.0 h))
(assert (>= P 1.0))
(assert (<= (- h) b))
(assert (<= b (- h 1.0)))
(assert (= b0 (- h 1.0)))
(check-sat) ; expect sat
(assert (not (and (<= (- (* 2.0 (- m 1.0) P)) (* 2.0 P (- b b0))) (<= (* 2.0 P (- b b0)) 0.0))))
(check-sat) ; expect unsat
(pop 1)

; lemma: deviation_function_with_half_load
; -(v + P) <= F, and m*F <= m*(v + P) + 2*((P - 1)*v - P): the shares together.
; mutant: replace "(<= 0.0 grown)" by "(<= (- P) grown)"
; mutant: replace "(<= grown (* 2.0 (- P 1.0) v))" by "(<= grown (* 2.0 P v))"
(push 1)
(declare-const m Real)
(declare-const P Real)
(declare-const v Real)
(declare-const F Real)
(declare-const grown Real)
(declare-const across Real) ; -2*a*v
(declare-const along Real) ; 2*P*(b - b0)
(assert (and (>= m 2.0) (>= P 1.0) (>= v 0.0)))
(assert (<= 0.0 grown))
(assert (<= grown (* 2.0 (- P 1.0) v)))
(assert (and (<= (- (* (- m 2.0) v)) across) (<= across (* m v))))
(assert (and (<= (- (* m P)) along) (<= along (* (- m 2.0) P))))
(assert (= (* m F) (+ grown across along)))
(check-sat) ; expect sat
(assert (not (and (<= (- (+ v P)) F) (<= (* m F) (+ (* m (+ v P)) (* 2.0 (- (* (- P 1.0) v) P)))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: deviation_function_without_load
; -v <= F, and m*F <= m*(v + 2P) + 2*((P - 1)*v - P).
; mutant: replace "(<= 0.0 along)" by "(<= (- (* m P)) along)"
; mutant: replace "(<= grown (* 2.0 (- P 1.0) v))" by "(<= grown (* 2.0 P v))"
(push 1)
(declare-const m Real)
(declare-const P Real)
(declare-const v Real)
(declare-const F Real)
(declare-const grown Real)
(declare-const across Real) ; -2*a*v
(declare-const along Real) ; 2*P*(b - b0)
(assert (and (>= m 2.0) (>= P 1.0) (>= v 0.0)))
(assert (<= 0.0 grown))
(assert (<= grown (* 2.0 (- P 1.0) v)))
(assert (and (<= (- (* (- m 2.0) v)) across) (<= across (* m v))))
(assert (<= 0.0 along))
(assert (<= along (* 2.0 (- m 1.0) P)))
(assert (= (* m F) (+ grown across along)))
(check-sat) ; expect sat
(assert (not (and (<= (- v) F) (<= (* m F) (+ (* m (+ v (* 2.0 P))) (* 2.0 (- (* (- P 1.0) v) P)))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: deviation_function_with_full_load
; -(v + 2P) <= F, and m*F <= m*v + 2*(P - 1)*v.
; mutant: replace "(<= along 0.0)" by "(<= along P)"
; mutant: replace "(<= grown (* 2.0 (- P 1.0) v))" by "(<= grown (* 2.0 P v))"
(push 1)
(declare-const m Real)
(declare-const P Real)
(declare-const v Real)
(declare-const F Real)
(declare-const grown Real)
(declare-const across Real) ; -2*a*v
(declare-const along Real) ; 2*P*(b - b0)
(assert (and (>= m 2.0) (>= P 1.0) (>= v 0.0)))
(assert (<= 0.0 grown))
(assert (<= grown (* 2.0 (- P 1.0) v)))
(assert (and (<= (- (* (- m 2.0) v)) across) (<= across (* m v))))
(assert (<= (- (* 2.0 (- m 1.0) P)) along))
(assert (<= along 0.0))
(assert (= (* m F) (+ grown across along)))
(check-sat) ; expect sat
(assert (not (and (<= (- (+ v (* 2.0 P))) F) (<= (* m F) (+ (* m v) (* 2.0 (- P 1.0) v))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: register_term
; (P - 1)*v - P <= (small - 1)*room, as neither P nor v is above room.
; mutant: replace "(<= v room)" by "true"
; mutant: replace "(<= P room)" by "true"
; mutant: replace "(>= v 1.0)" by "true"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const room Real)
(assert (>= P 1.0))
(assert (>= v 1.0))
(assert (<= P room))
(assert (<= v room))
(define-fun small () Real (ite (<= P v) P v))
(check-sat) ; expect sat
(assert (not (<= (- (* (- P 1.0) v) P) (* (- small 1.0) room))))
(check-sat) ; expect unsat
(pop 1)

; lemma: register_term_over_the_modulus
; So, with room = k*m, F <= first + 2k*(small - 1), where `first` is v + P or v + 2P.
; mutant: replace "(<= term (* (- small 1.0) k m))" by "(<= term (* small k m))"
(push 1)
(declare-const m Real)
(declare-const k Real)
(declare-const F Real)
(declare-const first Real)
(declare-const small Real)
(declare-const term Real) ; (P - 1)*v - P
(assert (and (> m 0.0) (> k 0.0)))
(assert (<= (* m F) (+ (* m first) (* 2.0 term))))
(assert (<= term (* (- small 1.0) k m)))
(check-sat) ; expect sat
(assert (not (<= F (+ first (* 2.0 k (- small 1.0))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: down_the_gradient
; At (u + e*P, v - e*v), which is e*sqrt(s2) from the point, square to where the first order of F stays as it is, F is
; less by 2*e*s2 - e^2*v^2. (Inside, e < 0.)
; mutant: replace "(* 2.0 e s2)" by "(* e s2)"
; mutant: replace "(* e e v v)" by "0.0"
(push 1)
(declare-const P Real)
(declare-const u Real)
(declare-const v Real)
(declare-const e Real)
(define-fun F () Real (- (* v v) (* 2.0 P u)))
(define-fun s2 () Real (+ (* P P) (* v v)))
(define-fun uthere () Real (+ u (* e P)))
(define-fun vthere () Real (- v (* e v)))
(define-fun there () Real (- (* vthere vthere) (* 2.0 P uthere)))
(check-sat) ; expect sat
(assert (not (= there (+ (- F (* 2.0 e s2)) (* e e v v)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: sum_by_the_diagonal
; (v + P)^2 <= 2*s2. (The assertion: a square is not negative.)
; mutant: replace "(* 2.0 s2)" by "(* 1.9 s2)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(define-fun s2 () Real (+ (* P P) (* v v)))
(assert (>= (* (- v P) (- v P)) 0.0))
(check-sat) ; expect sat
(assert (not (<= (* (+ v P) (+ v P)) (* 2.0 s2))))
(check-sat) ; expect unsat
(pop 1)

; lemma: sum_with_the_parameter_twice
; (v + 2P)^2 <= 5*s2, and (1.58*(v + P))^2 <= 5*s2. (The assertions: squares are not negative.)
; mutant: replace "(* 5.0 s2)" by "(* 4.99 s2)"
; mutant: replace "1.58 1.58" by "1.59 1.59"
(push 1)
(declare-const P Real)
(declare-const v Real)
(define-fun s2 () Real (+ (* P P) (* v v)))
(define-fun sum () Real (+ v P))
(define-fun most () Real (* 5.0 s2))
(assert (>= (* (- (* 2.0 v) P) (- (* 2.0 v) P)) 0.0))
(assert (>= (* (- v P) (- v P)) 0.0))
(assert (>= (* v v) 0.0))
(assert (>= (* P P) 0.0))
(check-sat) ; expect sat
(assert (not (and (<= (* (+ v (* 2.0 P)) (+ v (* 2.0 P))) most) (<= (* 1.58 1.58 sum sum) most))))
(check-sat) ; expect unsat
(pop 1)

; lemma: root_of_the_sum
; What has a smaller square than r >= 0 is not above r: v + P <= r = sqrt(2*s2), and likewise for 5*s2.
; mutant: replace "(<= 0.0 r)" by "true"
; mutant: replace "(<= (* sum sum) (* r r))" by "(<= (* sum sum) (* 2.0 r r))"
(push 1)
(declare-const sum Real)
(declare-const r Real)
(assert (<= 0.0 r))
(assert (<= (* sum sum) (* r r)))
(check-sat) ; expect sat
(assert (not (<= sum r)))
(check-sat) ; expect unsat
(pop 1)

; lemma: inside
; F >= -first, with first <= 2*d*s, s = sqrt(s2): at e = -d/s, which is d away, F is not below 0, so that the parabola is
; met on the way. Half load: first = v + P and d = sqrt(2)/2; without load v and 1/2; full load v + 2P and
; sqrt(5)/2.
; mutant: replace "(* 2.0 d s)" by "(* 3.0 d s)"
; mutant: replace "(<= (- first) F)" by "(<= (- (* 2.0 first)) F)"
(push 1)
(declare-const d Real)
(declare-const s Real)
(declare-const v Real)
(declare-const F Real)
(declare-const first Real)
(declare-const e Real)
(assert (> s 0.0))
(assert (<= first (* 2.0 d s)))
(assert (<= (- first) F))
(assert (= (* e s) (- d)))
(check-sat) ; expect sat
(assert (not (>= (+ (- F (* 2.0 e s s)) (* e e v v)) 0.0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: bend
; Outside, e*sqrt(s2) = d makes bend = e^2*v^2 what d^2*v^2/s2 is: d^2 at most, and d^2/2 while v <= P.
; mutant: replace "(<= v P)" by "true"
; mutant: replace "(<= bend dd)" by "(<= bend (* 0.9 dd))"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const dd Real) ; d^2
(declare-const bend Real)
(define-fun s2 () Real (+ (* P P) (* v v)))
(assert (and (>= P 1.0) (>= v 1.0) (>= dd 0.0)))
(assert (= (* bend s2) (* dd v v)))
(check-sat) ; expect sat
(assert (not (and (<= bend dd) (=> (<= v P) (<= (* 2.0 bend) dd)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: room_for_the_bend
; Above the diagonal, v >= P, (v - P + 2)*s2 >= (25/8)*v^2.
; mutant: replace "(* 3.125 v v)" by "(* 4.1 v v)"
; mutant: replace "(>= P 1.0)" by "(>= P 0.1)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(define-fun s2 () Real (+ (* P P) (* v v)))
(assert (>= P 1.0))
(assert (>= v P))
(check-sat) ; expect sat
(assert (not (>= (* (+ (- v P) 2.0) s2) (* 3.125 v v))))
(check-sat) ; expect unsat
(pop 1)

; lemma: room_for_a_smaller_bend
; Likewise (v - P + 1)*s2 >= 2*v^2.
; mutant: replace "(* 2.0 v v)" by "(* 2.1 v v)"
; mutant: replace "(>= P 1.0)" by "(>= P 0.5)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(define-fun s2 () Real (+ (* P P) (* v v)))
(assert (>= P 1.0))
(assert (>= v P))
(check-sat) ; expect sat
(assert (not (>= (* (+ (- v P) 1.0) s2) (* 2.0 v v))))
(check-sat) ; expect unsat
(pop 1)

; lemma: bend_with_half_load
; With none, one and two headroom bits (1 + k)^2/2 <= (25/8)*k.
; mutant: replace "(= k 0.25)" by "(= k 0.125)"
; mutant: replace "3.125" by "3.0"
(push 1)
(declare-const k Real)
(assert (or (= k 1.0) (= k 0.5) (= k 0.25)))
(check-sat) ; expect sat
(assert (not (<= (* 0.5 (+ 1.0 k) (+ 1.0 k)) (* 3.125 k))))
(check-sat) ; expect unsat
(pop 1)

; lemma: bend_over_the_gradient
; So bend*s2 = d^2*v^2 with d^2 <= (25/8)*k is (25/8)*k*v^2 at most, hence k*(v - P + 2)*s2 at most, with the room above.
; mutant: replace "(* 3.125 k)" by "(* 3.2 k)"
; mutant: replace "(>= k 0.0)" by "true"
(push 1)
(declare-const k Real)
(declare-const dd Real) ; d^2
(declare-const vv Real) ; v^2
(declare-const fits Real) ; (v - P + 2)*s2
(assert (>= k 0.0))
(assert (>= vv 0.0))
(assert (>= fits (* 3.125 vv)))
(assert (<= dd (* 3.125 k)))
(check-sat) ; expect sat
(assert (not (<= (* dd vv) (* k fits))))
(check-sat) ; expect unsat
(pop 1)

; lemma: bend_fits_its_room
; And s2 can be struck out: bend <= k*(v - P + 2).
; mutant: replace "(> s2 0.0)" by "(>= s2 0.0)"
(push 1)
(declare-const s2 Real)
(declare-const bend Real)
(declare-const fits Real) ; k*(v - P + 2)
(assert (> s2 0.0))
(assert (<= (* bend s2) (* fits s2)))
(check-sat) ; expect sat
(assert (not (<= bend fits)))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_with_half_load
; d = (1 + k)/sqrt(2), so that 2*d*s = (1 + k)*r with r = sqrt(2*s2): F is not above 0 there.
; mutant: replace "(* 2.0 k (- small 1.0))" by "(* 2.0 k (+ small 1.0))"
; mutant: replace "(<= (+ v P) r)" by "(<= v r)"
; mutant: replace "(<= (* 2.0 bend) dd)" by "(<= bend (* 2.0 dd))"
(push 1)
(declare-const k Real)
(declare-const P Real)
(declare-const v Real)
(declare-const r Real)
(declare-const F Real)
(declare-const bend Real)
(define-fun small () Real (ite (<= P v) P v))
(define-fun dd () Real (* 0.5 (+ 1.0 k) (+ 1.0 k)))
(assert (and (>= k 0.25) (<= k 1.0) (>= P 1.0) (>= v 1.0)))
(assert (<= F (+ v P (* 2.0 k (- small 1.0)))))
(assert (<= (+ v P) r))
(assert (=> (<= v P) (<= (* 2.0 bend) dd)))
(assert (=> (>= v P) (<= bend (* k (+ (- v P) 2.0)))))
(check-sat) ; expect sat
(assert (not (<= (+ (- F (* (+ 1.0 k) r)) bend) 0.0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: sum_of_whole_periods_and_a_rest
; With half load the remainder across, JR, is after the pulses a multiple of g = gcd(P,m) below P, each of the T = P/g of
; them once a period. Whole periods of `whole` pulses have the sum whole*(P - g)/2, and the w largest of the T have
; w*(P - g) - g*w*(w - 1)/2; together that is v*(P - g)/2 + g*w*(T - w)/2.
; mutant: replace "(- w 1.0)" by "w"
(push 1)
(declare-const g Real)
(declare-const T Real)
(declare-const whole Real)
(declare-const w Real)
(define-fun P () Real (* g T))
(define-fun v () Real (+ whole w))
(define-fun rest () Real (- (* w (- P g)) (* 0.5 g w (- w 1.0))))
(check-sat) ; expect sat
(assert (not (= (+ (* 0.5 whole (- P g)) rest) (+ (* 0.5 v (- P g)) (* 0.5 g w (- T w))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: largest_rest
; w*(T - w) <= T^2/4. (The assertion: a square is not negative.)
; mutant: replace "(* 0.25 T T)" by "(* 0.24 T T)"
(push 1)
(declare-const T Real)
(declare-const w Real)
(assert (>= (* (- T (* 2.0 w)) (- T (* 2.0 w))) 0.0))
(check-sat) ; expect sat
(assert (not (<= (* w (- T w)) (* 0.25 T T))))
(check-sat) ; expect unsat
(pop 1)

; lemma: sum_of_the_remainders
; So the sum is v*P/2 + P^2/8 at most, and grown, its double, v*P + P^2/4. The products are unknowns: vg = v*g >= 0,
; gwT = g*w*(T - w) <= g*T^2/4 = P*T/4, and PT = P*T <= P^2.
; mutant: replace "(<= PT PP)" by "(<= PT (* 2.0 PP))"
; mutant: replace "(>= vg 0.0)" by "true"
(push 1)
(declare-const vP Real)
(declare-const vg Real)
(declare-const gwT Real)
(declare-const PT Real)
(declare-const PP Real)
(declare-const grown Real)
(assert (>= vg 0.0))
(assert (<= gwT (* 0.25 PT)))
(assert (<= PT PP))
(assert (<= grown (* 2.0 (+ (* 0.5 (- vP vg)) (* 0.5 gwT)))))
(check-sat) ; expect sat
(assert (not (<= grown (+ vP (* 0.25 PP)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: register_term_of_the_sum
; v*P + P^2/4 <= (small/2 + P/8)*m with a headroom bit.
; mutant: replace "(<= (* 2.0 v) m)" by "(<= v m)"
; mutant: replace "(<= (* 2.0 P) m)" by "(<= P m)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const m Real)
(define-fun small () Real (ite (<= P v) P v))
(assert (and (>= P 1.0) (>= v 1.0)))
(assert (<= (* 2.0 P) m))
(assert (<= (* 2.0 v) m))
(check-sat) ; expect sat
(assert (not (<= (+ (* v P) (* 0.25 P P)) (* (+ (* 0.5 small) (* 0.125 P)) m))))
(check-sat) ; expect unsat
(pop 1)

; lemma: bend_beside_the_diagonal
; Above it, with v written as P + beside, v^2 <= (1 + beside)/2*s2, and <= (1/2 + beside/5)*s2 from v + P = 5 on.
; mutant: replace "(>= (+ v P) 5.0)" by "(>= (+ v P) 4.5)"
; mutant: replace "(* 0.5 beside)" by "(* 0.4 beside)"
(push 1)
(declare-const P Real)
(declare-const beside Real)
(define-fun v () Real (+ P beside))
(define-fun s2 () Real (+ (* P P) (* v v)))
(assert (>= P 1.0))
(assert (>= beside 0.0))
(check-sat) ; expect sat
(assert (not (and (<= (* v v) (* (+ 0.5 (* 0.5 beside)) s2))
                  (=> (>= (+ v P) 5.0) (<= (* v v) (* (+ 0.5 (* 0.2 beside)) s2))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_with_half_load_and_a_headroom_bit
; d = 1, so that 2*d*s = sqrt(2)*r >= 1.4142*r, and d^2 = 1. The first bound of F serves up to v + P = 5, the second one
; from there on.
; mutant: replace "(* 0.125 P)" by "(* 0.3 P)"
; mutant: replace "(+ v P small (- 1.0))" by "(+ v P small)"
; mutant: replace "(<= (* 2.0 bend) 1.0)" by "(<= bend 1.0)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const r Real)
(declare-const F Real)
(declare-const bend Real)
(define-fun small () Real (ite (<= P v) P v))
(assert (and (>= P 1.0) (>= v 1.0)))
(assert (<= F (+ v P small (- 1.0))))
(assert (<= F (+ v P (* 0.5 small) (* 0.125 P))))
(assert (<= (+ v P) r))
(assert (=> (<= v P) (<= (* 2.0 bend) 1.0)))
(assert (=> (>= v P) (<= bend (+ 0.5 (* 0.5 (- v P))))))
(assert (=> (and (>= v P) (>= (+ v P) 5.0)) (<= bend (+ 0.5 (* 0.2 (- v P))))))
(check-sat) ; expect sat
(assert (not (<= (+ (- F (* 1.4142 r)) bend) 0.0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_without_load
; k = 1 and d = 5*sqrt(2)/4, so that 2*d*s = (5/2)*r and d^2 = 25/8.
; mutant: replace "(* 2.0 (- small 1.0))" by "(* 2.0 (+ small 1.0))"
; mutant: replace "(<= (+ v P) r)" by "(<= v r)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const r Real)
(declare-const F Real)
(declare-const bend Real)
(define-fun small () Real (ite (<= P v) P v))
(assert (and (>= P 1.0) (>= v 1.0)))
(assert (<= F (+ v (* 2.0 P) (* 2.0 (- small 1.0)))))
(assert (<= (+ v P) r))
(assert (=> (<= v P) (<= (* 2.0 bend) 3.125)))
(assert (=> (>= v P) (<= bend (+ (- v P) 2.0))))
(check-sat) ; expect sat
(assert (not (<= (+ (- F (* 2.5 r)) bend) 0.0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_without_load_with_a_headroom_bit
; k = 1/2 and d = sqrt(2), so that 2*d*s = 2*r and d^2 = 2.
; mutant: replace "(- small 1.0)" by "small"
; mutant: replace "(<= (+ v P) r)" by "(<= v r)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const r Real)
(declare-const F Real)
(declare-const bend Real)
(define-fun small () Real (ite (<= P v) P v))
(assert (and (>= P 1.0) (>= v 1.0)))
(assert (<= F (+ v (* 2.0 P) (- small 1.0))))
(assert (<= (+ v P) r))
(assert (=> (<= v P) (<= (* 2.0 bend) 2.0)))
(assert (=> (>= v P) (<= bend (+ (- v P) 1.0))))
(check-sat) ; expect sat
(assert (not (<= (+ (- F (* 2.0 r)) bend) 0.0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: register_term_with_full_load
; (P - 1)*v over m is P - 1 at most, as v is not above m; and, as P is not, v, or v - 1 where P = v.
; mutant: replace "(<= v m)" by "(<= v (+ m 1.0))"
; mutant: replace "(<= P m)" by "(<= P (+ m 2.0))"
(push 1)
(declare-const m Real)
(declare-const P Real)
(declare-const v Real)
(declare-const F Real)
(assert (and (> m 0.0) (>= P 1.0) (>= v 1.0)))
(assert (<= v m))
(assert (<= P m))
(assert (<= (* m F) (+ (* m v) (* 2.0 (- P 1.0) v))))
(check-sat) ; expect sat
(assert (not (and (<= F (+ v (* 2.0 (- P 1.0)))) (<= F (* 3.0 v)) (=> (= P v) (<= F (- (* 3.0 v) 2.0))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_with_full_load_above_the_diagonal
; d = sqrt(5)/2, so that 2*d*s = r with r = sqrt(5*s2), and d^2 = 5/4. While v >= P:
; mutant: replace "(* 2.0 (- P 1.0))" by "(* 2.0 P)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const r Real)
(declare-const F Real)
(declare-const bend Real)
(assert (<= F (+ v (* 2.0 (- P 1.0)))))
(assert (<= (+ v (* 2.0 P)) r))
(assert (<= bend 1.25))
(check-sat) ; expect sat
(assert (not (<= (+ (- F r) bend) 0.0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: outside_with_full_load_below_the_diagonal
; And while v <= P, where both are whole: P = v, or P >= v + 1.
; mutant: replace "(>= P (+ v 1.0))" by "(>= P v)"
; mutant: replace "(- (* 3.0 v) 2.0)" by "(* 3.0 v)"
; mutant: replace "(* 1.58 (+ v P))" by "(+ v P)"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const r Real)
(declare-const F Real)
(declare-const bend Real)
(assert (>= v 1.0))
(assert (>= r (* 1.58 (+ v P))))
(assert (or (and (= P v) (<= F (- (* 3.0 v) 2.0)))
            (and (>= P (+ v 1.0)) (<= F (* 3.0 v)))))
(assert (<= (* 2.0 bend) 1.25))
(check-sat) ; expect sat
(assert (not (<= (+ (- F r) bend) 0.0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_in_its_row
; The end (U,V) is on the parabola, and the axis across stands at V: u grows, F falls to 0 from above, and s2 stays as
; it is: the bound goes on to hold.
; mutant: replace "(<= u U)" by "true"
(push 1)
(declare-const P Real)
(declare-const u Real)
(declare-const U Real)
(declare-const V Real)
(assert (>= P 1.0))
(assert (= (* V V) (* 2.0 P U)))
(assert (<= u U))
(define-fun before () Real (- (* V V) (* 2.0 P (- u 1.0))))
(define-fun after () Real (- (* V V) (* 2.0 P u)))
(check-sat) ; expect sat
(assert (not (and (<= 0.0 after) (<= after before))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_in_its_column
; The axis along stands at U: v grows, F rises to 0 from below, and -2*d*s falls.
; mutant: replace "(<= v V)" by "true"
(push 1)
(declare-const P Real)
(declare-const v Real)
(declare-const U Real)
(declare-const V Real)
(assert (and (>= P 1.0) (>= v 1.0)))
(assert (= (* V V) (* 2.0 P U)))
(assert (<= v V))
(define-fun before () Real (- (* (- v 1.0) (- v 1.0)) (* 2.0 P U)))
(define-fun after () Real (- (* v v) (* 2.0 P U)))
(check-sat) ; expect sat
(assert (not (and (<= before after) (<= after 0.0))))
(check-sat) ; expect unsat
(pop 1)

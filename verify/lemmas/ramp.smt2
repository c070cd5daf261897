; What stopping takes from the speed start + m*a, m steps of the acceleration up:
;   D(m) = m*start + a*m*(m - 1)/2, the sum of the speeds below it. Below, twice that.
(set-logic QF_NIA)

; lemma: a_step_up_adds_the_speed
; 2*D(m + 1) - 2*D(m) = 2*(start + m*a).
; mutant: replace "(* 2 (+ start (* m a)))" by "(* 2 (+ start (* (+ m 1) a)))"
(push 1)
(declare-const m Int)
(declare-const a Int)
(declare-const start Int)
(check-sat) ; expect sat
(assert (not (= (- (+ (* 2 (+ m 1) start) (* a (+ m 1) m))
                   (+ (* 2 m start) (* a m (- m 1))))
                (* 2 (+ start (* m a))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: the_next_speed_down_and_the_first_are_part_of_it
; m >= 2: D(m) >= start + (start + (m - 1)*a). Written with k = m - 2, ka = k*a and t = k*(k - 1)*a, of which
; k*(k - 1) is not negative: 2*D(k + 2) = 2*k*start + 4*start + a*(k + 2)*(k + 1), the last t + 4*k*a + 2*a.
; mutant: replace "(assert (>= kstart 0))" by ""
; mutant: replace "(assert (>= t 0))" by ""
(push 1)
(declare-const kstart Int)
(declare-const ka Int)
(declare-const t Int)
(declare-const a Int)
(declare-const start Int)
(assert (>= start 1))
(assert (>= a 1))
(assert (>= ka 0))
(assert (>= kstart 0))
(assert (>= t 0))
(check-sat) ; expect sat
(assert (not (>= (+ (* 2 kstart) (* 4 start) t (* 4 ka) (* 2 a))
                 (* 2 (+ start start ka a)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: the_parts_of_it
; The terms that the lemma above takes for 2*D(k + 2).
; mutant: replace "(* 4 k a)" by "(* 3 k a)"
(push 1)
(declare-const k Int)
(declare-const a Int)
(declare-const start Int)
(check-sat) ; expect sat
(assert (not (= (+ (* 2 (+ k 2) start) (* a (+ k 2) (+ k 1)))
                (+ (* 2 k start) (* 4 start) (* k (- k 1) a) (* 4 k a) (* 2 a)))))
(check-sat) ; expect unsat
(pop 1)

; The S-curve's window of w ways, of any size: `sum` is that of all ways in it, `earliest` the one that leaves
; it next, `way` the one that comes in. A way that is `age` clocks old is in w - 1 - age more sums; m is the
; sum of (w - 1 - age)*way over the ring, and w*left + m what is to come.
(set-logic QF_NIA)

; lemma: a_clock_moves_what_it_takes_from_what_is_to_come
; Each way but the earliest, which has a factor of 0, gets a clock older: m loses sum - earliest. The new way
; comes in with the factor w - 1, and leaves the trapezoid's way.
; mutant: replace "(* (- w 1) way)" by "(* w way)"
; mutant: replace "(* w (- left way))" by "(* w left)"
(push 1)
(declare-const w Int)
(declare-const way Int)
(declare-const left Int)
(declare-const sum Int)
(declare-const earliest Int)
(declare-const m Int)
(check-sat) ; expect sat
(assert (not (= (+ (* w (- left way)) (- m (- sum earliest)) (* (- w 1) way)
                   (+ (- sum earliest) way))
                (+ (* w left) m))))
(check-sat) ; expect unsat
(pop 1)

; lemma: the_sum_stays_that_of_the_ring
; The earliest goes, the new way takes its place; `others` are the ways between them.
; mutant: replace "(assert (= sum (+ earliest others)))" by ""
(push 1)
(declare-const way Int)
(declare-const sum Int)
(declare-const earliest Int)
(declare-const others Int)
(assert (= sum (+ earliest others)))
(check-sat) ; expect sat
(assert (not (= (+ (- sum earliest) way) (+ others way))))
(check-sat) ; expect unsat
(pop 1)

; lemma: nothing_is_to_come_when_only_the_earliest_is_left
; m is at most w - 1 times the ways that it has a factor for, and not negative: so it is 0 with their sum.
; mutant: replace "(assert (<= m (* (- w 1) others)))" by ""
; mutant: replace "(assert (= others 0))" by ""
(push 1)
(declare-const w Int)
(declare-const others Int)
(declare-const m Int)
(assert (>= w 2))
(assert (>= m 0))
(assert (<= m (* (- w 1) others)))
(assert (= others 0))
(check-sat) ; expect sat
(assert (not (= m 0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: the_phase_has_at_most_one_carry
; w ways of at most `largest` < modulus, the register below w*modulus: below two carries after the clock.
; wl and wm are w*largest and w*modulus.
; mutant: replace "(assert (< wl wm))" by ""
; mutant: replace "(assert (< phase wm))" by ""
(push 1)
(declare-const wl Int)
(declare-const wm Int)
(declare-const sum Int)
(declare-const phase Int)
(assert (>= sum 0))
(assert (<= sum wl))
(assert (< wl wm))
(assert (>= phase 0))
(assert (< phase wm))
(check-sat) ; expect sat
(assert (not (< (+ phase sum) (* 2 wm))))
(check-sat) ; expect unsat
(pop 1)

; lemma: a_change_more_adds_the_acceleration
; Changes of the way add up: if i of them are within i*a + j, where j is max(0, start - a) once the start
; speed is among them, then with one more within a it is (i + 1)*a + j.
; mutant: replace "(assert (<= change a))" by ""
; mutant: replace "(+ (* (+ i 1) a) j)" by "(+ (* i a) j)"
(push 1)
(declare-const i Int)
(declare-const a Int)
(declare-const j Int)
(declare-const changes Int)
(declare-const change Int)
(assert (<= changes (+ (* i a) j)))
(assert (<= change a))
(check-sat) ; expect sat
(assert (not (<= (+ changes change) (+ (* (+ i 1) a) j))))
(check-sat) ; expect unsat
(pop 1)

; lemma: the_start_speed_among_the_changes
; i changes within a each, and one of start: within (i + 1)*a + max(0, start - a).
; mutant: replace "(assert (>= j (- start a)))" by ""
(push 1)
(declare-const i Int)
(declare-const a Int)
(declare-const j Int)
(declare-const start Int)
(declare-const changes Int)
(assert (<= changes (* i a)))
(assert (>= j (- start a)))
(check-sat) ; expect sat
(assert (not (<= (+ changes start) (+ (* (+ i 1) a) j))))
(check-sat) ; expect unsat
(pop 1)

; lemma: the_jerk_is_two_changes
; The sum changes by `way - earliest`, and the clock before it did by `last - gone`, where last is the way
; before way, and gone left before earliest: it differs by two changes of the way, each within c.
; mutant: replace "(assert (<= (- c) (- earliest gone)))" by ""
; mutant: replace "(assert (<= (- way last) c))" by ""
(push 1)
(declare-const way Int)
(declare-const last Int)
(declare-const earliest Int)
(declare-const gone Int)
(declare-const c Int)
(assert (<= (- c) (- way last)))
(assert (<= (- way last) c))
(assert (<= (- c) (- earliest gone)))
(assert (<= (- earliest gone) c))
(check-sat) ; expect sat
(assert (not (<= (- (* 2 c)) (- (- way earliest) (- last gone)) (* 2 c))))
(check-sat) ; expect unsat
(pop 1)

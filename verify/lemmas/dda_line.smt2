; The line by digital integration, one axis or several.
;
;   m        the register's modulus, 2^n (nothing below needs it to be a power of two)
;   J, JR    an axis' integrand and remainder registers
;   c        the carry: 1 if JR + J >= m, else 0
;   i, P     the accumulations and the pulses made so far
;   e        i*J - P*m: how far the axis lags behind its line, in m-th parts of a pulse
;   left     the accumulations still to be made, and `lacking` the pulses that the axis lacks
;
; The argument is in docs/proofs/dda_line.md.
(set-logic QF_NIRA)

; lemma: accumulation
; P*m + JR = preset + i*J goes on to hold: what leaves the register is worth m.
; mutant: replace "(- (+ JR J) (* c m))" by "(+ JR J)"
; mutant: replace "(* (+ i 1) J)" by "(* i J)"
(push 1)
(declare-const m Int)
(declare-const J Int)
(declare-const JR Int)
(declare-const c Int)
(declare-const i Int)
(declare-const P Int)
(declare-const preset Int)
(assert (= (+ (* P m) JR) (+ preset (* i J))))
(define-fun JRafter () Int (- (+ JR J) (* c m)))
(check-sat) ; expect sat
(assert (not (= (+ (* (+ P c) m) JRafter) (+ preset (* (+ i 1) J)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: remainder_stays_in_its_register
; 0 <= JR < m goes on to hold, as J < m makes one carry enough.
; mutant: replace "(< J m)" by "(<= J (+ m 1))"
; mutant: replace "(>= (+ JR J) m)" by "(> (+ JR J) m)"
(push 1)
(declare-const m Int)
(declare-const J Int)
(declare-const JR Int)
(assert (and (<= 0 J) (< J m)))
(assert (and (<= 0 JR) (< JR m)))
(define-fun JRafter () Int (ite (>= (+ JR J) m) (- (+ JR J) m) (+ JR J)))
(check-sat) ; expect sat
(assert (not (and (<= 0 JRafter) (< JRafter m))))
(check-sat) ; expect unsat
(pop 1)

; lemma: lag_is_the_change_of_the_remainder
; e = JR - preset.
; mutant: replace "(- JR preset)" by "(- preset JR)"
(push 1)
(declare-const m Int)
(declare-const J Int)
(declare-const JR Int)
(declare-const i Int)
(declare-const P Int)
(declare-const preset Int)
(assert (= (+ (* P m) JR) (+ preset (* i J))))
(check-sat) ; expect sat
(assert (not (= (- (* i J) (* P m)) (- JR preset))))
(check-sat) ; expect unsat
(pop 1)

; lemma: lag_of_an_axis
; With the preset 0 an axis is less than one pulse late, 0 <= e < m; with full load, m - 1, less than
; one pulse early, -m < e <= 0; with half load, m/2, at most half a pulse either, -m/2 <= e < m/2.
; mutant: replace "(= preset (- m 1))" by "(= preset m)"
; mutant: replace "(< (* 2 e) m)" by "(< (* 2 e) (- m 2))"
; mutant: replace "(< e m)" by "(< e (- m 1))"
(push 1)
(declare-const m Int)
(declare-const JR Int)
(declare-const preset Int)
(assert (and (<= 0 JR) (< JR m)))
(define-fun e () Int (- JR preset))
(check-sat) ; expect sat
(assert (not (and (=> (= preset 0) (and (<= 0 e) (< e m)))
                  (=> (= preset (- m 1)) (and (< (- m) e) (<= e 0)))
                  (=> (= (* 2 preset) m) (and (<= (- m) (* 2 e)) (< (* 2 e) m))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: two_axes_late_or_early
; The distance from the line of two axes is |ex*Jy - ey*Jx| / (m*L) with L^2 = Jx^2 + Jy^2. Where both
; lags have one sign the two terms have opposite ones, so that neither exceeds m*L: less than a pulse.
; (Full load turns the signs of both lags, and of what is squared here not at all.)
; mutant: replace "(<= 0.0 ey)" by "(<= (- m) ey)"
; mutant: replace "(< 0.0 (+ Jx Jy))" by "true"
(push 1)
(declare-const m Real)
(declare-const Jx Real)
(declare-const Jy Real)
(declare-const ex Real)
(declare-const ey Real)
(assert (and (<= 0.0 Jx) (<= 0.0 Jy) (< 0.0 (+ Jx Jy))))
(assert (and (<= 0.0 ex) (< ex m)))
(assert (and (<= 0.0 ey) (< ey m)))
(define-fun cross () Real (- (* ex Jy) (* ey Jx)))
(check-sat) ; expect sat
(assert (not (< (* cross cross) (* m m (+ (* Jx Jx) (* Jy Jy))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: two_axes_half_load
; With lags of half a pulse at most, 2*|ex*Jy - ey*Jx| <= m*(Jx + Jy).
; mutant: replace "(<= (* 2.0 ex) m)" by "(<= ex m)"
; mutant: replace "(<= (* 2.0 cross) (* m" by "(<= (* 2.1 cross) (* m"
(push 1)
(declare-const m Real)
(declare-const Jx Real)
(declare-const Jy Real)
(declare-const ex Real)
(declare-const ey Real)
(assert (and (<= 0.0 Jx) (<= 0.0 Jy)))
(assert (and (<= (- m) (* 2.0 ex)) (<= (* 2.0 ex) m)))
(assert (and (<= (- m) (* 2.0 ey)) (<= (* 2.0 ey) m)))
(define-fun cross () Real (- (* ex Jy) (* ey Jx)))
(check-sat) ; expect sat
(assert (not (and (<= (- (* m (+ Jx Jy))) (* 2.0 cross)) (<= (* 2.0 cross) (* m (+ Jx Jy))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: two_axes_half_load_squared
; In squares, 4*cross^2 <= w^2, with w = m*(Jx + Jy).
; mutant: replace "(* 4.0 cross cross)" by "(* 4.1 cross cross)"
; mutant: replace "(<= (- w) (* 2.0 cross))" by "true"
(push 1)
(declare-const cross Real)
(declare-const w Real)
(assert (<= (- w) (* 2.0 cross)))
(assert (<= (* 2.0 cross) w))
(check-sat) ; expect sat
(assert (not (<= (* 4.0 cross cross) (* w w))))
(check-sat) ; expect unsat
(pop 1)

; lemma: two_axes_half_load_diagonal
; And w^2 <= 2*m^2*(Jx^2 + Jy^2): so 2*cross^2 <= m^2*L^2, and the distance is at most half the square root of two. (Jy is
; written as Jx and what it is more.)
; mutant: replace "(* 2.0 m m" by "(* 1.9 m m"
(push 1)
(declare-const m Real)
(declare-const Jx Real)
(declare-const more Real)
(define-fun Jy () Real (+ Jx more))
(check-sat) ; expect sat
(assert (not (<= (* m m (+ Jx Jy) (+ Jx Jy)) (* 2.0 m m (+ (* Jx Jx) (* Jy Jy))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: lagrange_identity
; For more axes, |e|^2*|J|^2 - (e*J)^2, which is the distance squared times m^2*|J|^2, is the sum of the
; squares (ei*Jj - ej*Ji)^2 over all pairs of axes. Three axes stand for all: each product of two
; coordinates belongs to one pair.
; mutant: replace "(- (* e2 J3) (* e3 J2)) (- (* e2 J3) (* e3 J2))" by "(- (* e2 J3) (* e3 J2)) (- (* e2 J3) (* e3 J1))"
(push 1)
(declare-const e1 Real)
(declare-const e2 Real)
(declare-const e3 Real)
(declare-const J1 Real)
(declare-const J2 Real)
(declare-const J3 Real)
(define-fun dot () Real (+ (* e1 J1) (* e2 J2) (* e3 J3)))
(check-sat) ; expect sat
(assert (not (= (- (* (+ (* e1 e1) (* e2 e2) (* e3 e3)) (+ (* J1 J1) (* J2 J2) (* J3 J3)))
                   (* dot dot))
                (+ (* (- (* e1 J2) (* e2 J1)) (- (* e1 J2) (* e2 J1)))
                   (* (- (* e1 J3) (* e3 J1)) (- (* e1 J3) (* e3 J1)))
                   (* (- (* e2 J3) (* e3 J2)) (- (* e2 J3) (* e3 J2)))))))
(check-sat) ; expect unsat
(pop 1)

; lemma: three_axes_late_or_early
; Three axes make three pairs; by `two_axes_late_or_early` each pair's square is below m^2 times its own
; two J squared (or both are 0). Each axis is in two pairs: the distance squared is below 2. For N axes
; it is below N - 1 in the same way. Below, jk is Jk squared and cjk the square of the pair.
; mutant: replace "(* 2.0 m m" by "(* 1.9 m m"
(push 1)
(declare-const m Real)
(declare-const j1 Real)
(declare-const j2 Real)
(declare-const j3 Real)
(declare-const c12 Real)
(declare-const c13 Real)
(declare-const c23 Real)
(assert (and (< 0.0 m) (<= 0.0 j1) (<= 0.0 j2) (<= 0.0 j3) (< 0.0 (+ j1 j2 j3))))
(assert (ite (= 0.0 (+ j1 j2)) (= c12 0.0) (< c12 (* m m (+ j1 j2)))))
(assert (ite (= 0.0 (+ j1 j3)) (= c13 0.0) (< c13 (* m m (+ j1 j3)))))
(assert (ite (= 0.0 (+ j2 j3)) (= c23 0.0) (< c23 (* m m (+ j2 j3)))))
(check-sat) ; expect sat
(assert (not (< (+ c12 c13 c23) (* 2.0 m m (+ j1 j2 j3)))))
(check-sat) ; expect unsat
(pop 1)

; lemma: three_axes_can_be_off_by_more_than_a_pulse
; n = 3, the narrowest register that shows it, J = (1,1,7), seven accumulations from the preset 0: the
; lags are 7, 7 and 49 - 6*8 = 1, and the distance squared is (99*51 - 21*21) / (64*51) = 1.41.
; mutant: replace "(= i 7)" by "(= i 3)"
(push 1)
(declare-const i Int)
(assert (= i 7))
(define-fun e1 () Int (mod i 8))
(define-fun e3 () Int (mod (* 7 i) 8))
(define-fun dot () Int (+ e1 e1 (* 7 e3)))
(check-sat) ; expect sat
(assert (not (> (- (* (+ (* 2 e1 e1) (* e3 e3)) 51) (* dot dot)) (* 64 51))))
(check-sat) ; expect unsat
(pop 1)

; lemma: many_axes_half_load
; With lags of half a pulse at most, the distance is at most that of the two points themselves, |e|/m.
; So its square is at most N/4 for N axes: one pulse up to four axes. Here is what one axis adds.
; mutant: replace "(* 4.0 (+ sum (* e e)))" by "(* 5.0 (+ sum (* e e)))"
(push 1)
(declare-const m Real)
(declare-const axes Real)
(declare-const sum Real)
(declare-const e Real)
(assert (<= (* 4.0 sum) (* axes m m)))
(assert (and (<= (- m) (* 2.0 e)) (<= (* 2.0 e) m)))
(check-sat) ; expect sat
(assert (not (<= (* 4.0 (+ sum (* e e))) (* (+ axes 1.0) m m))))
(check-sat) ; expect unsat
(pop 1)

; lemma: start_of_the_count_down
; With J = S*E, S = 2^Q the scale of normalization, m/S accumulations are to be made and E pulses lack:
; left*J + JR = lacking*m + preset.
; mutant: replace "(= J (* S E))" by "(= J E)"
(push 1)
(declare-const m Int)
(declare-const S Int)
(declare-const E Int)
(declare-const J Int)
(declare-const left Int)
(declare-const preset Int)
(assert (= (* left S) m))
(assert (= J (* S E)))
(check-sat) ; expect sat
(assert (not (= (+ (* left J) preset) (+ (* E m) preset))))
(check-sat) ; expect unsat
(pop 1)

; lemma: count_down
; left*J + JR = lacking*m + preset goes on to hold.
; mutant: replace "(* (- left 1) J)" by "(* left J)"
; mutant: replace "(- lacking c)" by "(+ lacking c)"
(push 1)
(declare-const m Int)
(declare-const J Int)
(declare-const JR Int)
(declare-const c Int)
(declare-const left Int)
(declare-const lacking Int)
(declare-const preset Int)
(assert (= (+ (* left J) JR) (+ (* lacking m) preset)))
(define-fun JRafter () Int (- (+ JR J) (* c m)))
(check-sat) ; expect sat
(assert (not (= (+ (* (- left 1) J) JRafter) (+ (* (- lacking c) m) preset))))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_of_the_count_down
; When no accumulations are left, no pulses lack: JR - preset is a multiple of m, and the only one between
; -m and m is 0.
; mutant: replace "(< JR m)" by "(<= JR m)"
; mutant: replace "(= left 0)" by "(= left 1)"
(push 1)
(declare-const m Int)
(declare-const J Int)
(declare-const JR Int)
(declare-const left Int)
(declare-const lacking Int)
(declare-const preset Int)
(assert (= (+ (* left J) JR) (+ (* lacking m) preset)))
(assert (and (<= 0 JR) (< JR m)))
(assert (and (<= 0 preset) (< preset m)))
(assert (= left 0))
(check-sat) ; expect sat
(assert (not (= lacking 0)))
(check-sat) ; expect unsat
(pop 1)

; lemma: end_of_the_count_up
; The same from the other end: after m/S accumulations of J = S*E, i*J = m*E and the axis has had E pulses.
; mutant: replace "(< preset m)" by "(<= preset m)"
; mutant: replace "(* m E)" by "(* m E 2)"
(push 1)
(declare-const m Int)
(declare-const E Int)
(declare-const P Int)
(declare-const JR Int)
(declare-const preset Int)
(assert (= (+ (* P m) JR) (+ preset (* m E))))
(assert (and (<= 0 JR) (< JR m)))
(assert (and (<= 0 preset) (< preset m)))
(check-sat) ; expect sat
(assert (not (= P E)))
(check-sat) ; expect unsat
(pop 1)

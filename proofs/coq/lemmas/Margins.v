(** The margins of theory.md section 3, for every phi* in (0, pi/4].

    beta = phi/3, d = r sin beta, 0 < h <= 2 r sin(phi/12). With y = phi/12 (at most
    pi/48) everything is a polynomial in sin y and cos y: d = r sin 4y. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space SpokeBulge BoxBulge ArcSpacing.
Open Scope R_scope.

(** Algebraic bounds by halving pi/6 three times; no approximation of pi is used. *)
Lemma cos_half_ge x c k : 0 <= x <= PI -> c <= cos x -> 0 <= k -> 2 * (k * k) - 1 <= c -> k <= cos (x / 2).
Proof.
  intros Hx Hc Hk H. pose proof PI_RGT_0.
  assert (0 <= cos (x / 2)) by (apply cos_ge_0; lra).
  assert (E : cos x = 2 * cos (x / 2) * cos (x / 2) - 1).
  { replace x with (2 * (x / 2)) at 1 by field. apply cos_2a_cos. }
  apply sq_le; nra.
Qed.

Lemma cos_pi12 : 965925 / 1000000 <= cos (PI / 12).
Proof.
  pose proof PI_RGT_0. replace (PI / 12) with (PI / 6 / 2) by field.
  apply cos_half_ge with (c := 866025 / 1000000); try lra.
  rewrite cos_PI6. assert (173205 / 100000 <= sqrt 3); [|lra].
  pose proof sqrt3_sqr. pose proof sqrt3_pos. nra.
Qed.
Lemma cos_pi24 : 991444 / 1000000 <= cos (PI / 24).
Proof.
  pose proof PI_RGT_0. replace (PI / 24) with (PI / 12 / 2) by field.
  apply cos_half_ge with (c := 965925 / 1000000); try lra. exact cos_pi12.
Qed.
Lemma cos_pi48 : 997858 / 1000000 <= cos (PI / 48).
Proof.
  pose proof PI_RGT_0. replace (PI / 48) with (PI / 24 / 2) by field.
  apply cos_half_ge with (c := 991444 / 1000000); try lra. exact cos_pi24.
Qed.

Section Margins.
Variables phi y : R.
Hypothesis Hphi : 0 < phi <= PI / 4.
Hypothesis Hy : y = phi / 12.

Lemma y_range : 0 < y <= PI / 48. Proof. subst y. lra. Qed.

Lemma cos_y : 997858 / 1000000 <= cos y < 1.
Proof.
  pose proof y_range. pose proof PI_RGT_0. split.
  - apply Rle_trans with (1 := cos_pi48). apply cos_decr_1; lra.
  - rewrite <- cos_0. apply cos_decreasing_1; lra.
Qed.
Lemma cos_2y : 991444 / 1000000 <= cos (2 * y) < 1.
Proof.
  pose proof y_range. pose proof PI_RGT_0. split.
  - apply Rle_trans with (1 := cos_pi24). apply cos_decr_1; lra.
  - rewrite <- cos_0. apply cos_decreasing_1; lra.
Qed.
Lemma cos_4y : 965925 / 1000000 <= cos (4 * y) < 1.
Proof.
  pose proof y_range. pose proof PI_RGT_0. split.
  - apply Rle_trans with (1 := cos_pi12). apply cos_decr_1; lra.
  - rewrite <- cos_0. apply cos_decreasing_1; lra.
Qed.
Lemma sin_y : 0 < sin y <= 65411 / 1000000.
Proof.
  pose proof y_range. pose proof PI_RGT_0.
  assert (S0 : 0 < sin y) by (apply sin_gt_0; lra). split; [exact S0|].
  pose proof cos_2y as [C _]. rewrite cos_2a_sin in C. apply sq_le; nra.
Qed.
Lemma sin_4y_eq : sin (4 * y) = 4 * sin y * cos y * cos (2 * y).
Proof. replace (4 * y) with (2 * (2 * y)) by ring. rewrite sin_2a, (sin_2a y). ring. Qed.
Lemma sin_4y : 0 < sin (4 * y) /\ sin (4 * y) * sin (4 * y) <= 66989 / 1000000.
Proof.
  pose proof y_range. pose proof PI_RGT_0. split; [apply sin_gt_0; lra|].
  pose proof cos_4y as [C _]. pose proof (sin2_cos2 (4 * y)) as E. unfold Rsqr in E. nra.
Qed.

(** d / (2 r sin y) = 2 cos y cos 2y >= 1.978. *)
Lemma offset_ratio : 1978 / 1000 * (2 * sin y) <= sin (4 * y).
Proof.
  rewrite sin_4y_eq. pose proof cos_y as [C1 _]. pose proof cos_2y as [C2 _]. pose proof sin_y as [S _].
  assert (989 / 1000 <= cos y * cos (2 * y)) by nra. nra.
Qed.

(** cos beta sin phi / (2 sin y) >= 5.2. *)
Lemma vertex_separation_ratio : 52 / 10 * (2 * sin y) <= cos (4 * y) * sin (12 * y).
Proof.
  replace (12 * y) with (3 * (4 * y)) by ring.
  assert (E : sin (3 * (4 * y)) = sin (4 * y) * (3 - 4 * (sin (4 * y) * sin (4 * y)))).
  { rewrite sin_triple. pose proof (sin2_cos2 (4 * y)) as E. unfold Rsqr in E.
    replace (cos (4 * y) * cos (4 * y)) with (1 - sin (4 * y) * sin (4 * y)) by lra. ring. }
  rewrite E. pose proof sin_4y as [S4 SS]. pose proof cos_4y as [C4 _].
  pose proof sin_y as [S _]. pose proof cos_y as [C1 _]. pose proof cos_2y as [C2 _].
  assert (P : 989320 / 1000000 <= cos y * cos (2 * y)) by nra.
  assert (F : 395728 / 100000 * sin y <= sin (4 * y)) by (rewrite sin_4y_eq; nra).
  set (t := sin (4 * y)) in *. set (c := cos (4 * y)) in *. set (x := sin y) in *.
  assert (G : 27320 / 10000 <= 3 - 4 * (t * t)) by lra.
  assert (G2 : 26389 / 10000 <= c * (3 - 4 * (t * t))) by nra.
  replace (c * (t * (3 - 4 * (t * t)))) with (t * (c * (3 - 4 * (t * t)))) by ring.
  set (k := c * (3 - 4 * (t * t))) in *. nra.
Qed.

(** cos beta sin phi >= 2 sin beta: points at a vertex are 2d away from other edges. *)
Lemma offset_separation_ratio : 2 * sin (4 * y) <= cos (4 * y) * sin (12 * y).
Proof.
  replace (12 * y) with (3 * (4 * y)) by ring.
  assert (E : sin (3 * (4 * y)) = sin (4 * y) * (3 - 4 * (sin (4 * y) * sin (4 * y)))).
  { rewrite sin_triple. pose proof (sin2_cos2 (4 * y)) as E. unfold Rsqr in E.
    replace (cos (4 * y) * cos (4 * y)) with (1 - sin (4 * y) * sin (4 * y)) by lra. ring. }
  rewrite E. pose proof sin_4y as [S4 SS]. pose proof cos_4y as [C4 _].
  set (t := sin (4 * y)) in *. set (c := cos (4 * y)) in *.
  assert (G2 : 2 <= c * (3 - 4 * (t * t))) by nra.
  replace (c * (t * (3 - 4 * (t * t)))) with (t * (c * (3 - 4 * (t * t)))) by ring.
  set (k := c * (3 - 4 * (t * t))) in *. nra.
Qed.

(** cos phi < cos beta cos a for a <= phi/8: an edge at angle phi* from a face clears
    its spokes (L10, L15). *)
Lemma edge_face_ratio a : 0 <= a <= phi / 8 -> cos phi < cos (phi / 3) * cos a.
Proof.
  intros Ha. pose proof PI_RGT_0.
  assert (S1 : 0 < sin (phi / 3)) by (apply sin_gt_0; lra).
  assert (S2 : 0 <= sin a) by (apply sin_ge_0; lra).
  assert (cos phi < cos (phi / 3 + a)) by (apply cos_decreasing_1; lra).
  rewrite cos_plus in *. nra.
Qed.
End Margins.

(** The parameters of section 3. *)
Definition parameters r phi beta d h :=
  0 < r /\ 0 < phi <= PI / 4 /\ beta = phi / 3 /\ d = r * sin beta /\
  0 < h <= 2 * r * sin (phi / 12).

Section Margins2.
Variables r phi beta d h : R.
Hypothesis P : parameters r phi beta d h.

Lemma beta_is_4y : beta = 4 * (phi / 12).
Proof. destruct P as (_ & _ & -> & _). field. Qed.

(** d >= 1.978 h. *)
Theorem margin_offset : 1978 / 1000 * h <= d.
Proof.
  pose proof beta_is_4y as B. destruct P as (Hr & Hphi & _ & Hd & Hh). rewrite Hd, B.
  pose proof (offset_ratio phi (phi / 12) Hphi eq_refl) as K. nra.
Qed.

(** r >= 7.64 h. *)
Theorem margin_radius : 764 / 100 * h <= r.
Proof.
  destruct P as (Hr & Hphi & _ & _ & Hh).
  pose proof (sin_y phi (phi / 12) Hphi eq_refl) as [S0 S]. nra.
Qed.

(** Faces at a common vertex only: a point at distance >= r cos beta from v in one of
    them is at distance >= r cos beta sin phi* >= 5.2 h from the other. *)
Theorem margin_vertex_separation : 52 / 10 * h <= r * cos beta * sin phi.
Proof.
  pose proof beta_is_4y as B. destruct P as (Hr & Hphi & _ & _ & Hh). rewrite B.
  pose proof (vertex_separation_ratio phi (phi / 12) Hphi eq_refl) as K.
  replace phi with (12 * (phi / 12)) at 2 by field. nra.
Qed.

(** Points at distance >= r cos beta from v, at angle >= phi* from an edge: 2d away from it. *)
Theorem margin_offset_separation : 2 * d <= r * cos beta * sin phi.
Proof.
  pose proof beta_is_4y as B. destruct P as (Hr & Hphi & _ & Hd & Hh). rewrite Hd, B.
  pose proof (offset_separation_ratio phi (phi / 12) Hphi eq_refl) as K.
  replace phi with (12 * (phi / 12)) at 3 by field. nra.
Qed.

(** A subarc whose chord is at most 3h/2 is shorter than 2 beta, and nearly flat. *)
Theorem margin_half_angle a : 0 < a < PI / 2 -> 2 * r * sin a <= 3 / 2 * h ->
  a < beta /\ 995 / 1000 <= cos a.
Proof.
  intros Ha Hb. pose proof margin_offset as MO. pose proof margin_radius as MR. pose proof PI_RGT_0.
  destruct P as (Hr & Hphi & EB & Hd & Hh).
  assert (S1 : r * sin a < r * sin beta) by lra.
  assert (S2 : sin a < sin beta) by (apply Rmult_lt_reg_l with r; assumption).
  split.
  - destruct (Rlt_le_dec a beta) as [L|L]; [exact L|].
    assert (sin beta <= sin a) by (apply sin_incr_1; lra). lra.
  - pose proof (sin2_cos2 a) as E. unfold Rsqr in E.
    assert (0 < sin a) by (apply sin_gt_0; lra). assert (0 < cos a) by (apply cos_gt_0; lra).
    assert (sin a <= 98169 / 1000000) by nra. apply sq_le; nra.
Qed.

(** ... and the geometric fact behind it. *)
Theorem distance_from_angle x y k : norm2 x = k * k -> 0 <= k -> 0 <= phi <= PI / 2 ->
  dot x y <= norm x * norm y * cos phi -> (k * sin phi) * (k * sin phi) <= dist2 x y.
Proof.
  intros X K Hp A.
  assert (NX : norm x = k).
  { unfold norm. rewrite X. apply sqrt_square. exact K. }
  rewrite NX in A. pose proof (norm_sqr y) as Y. pose proof (norm_nonneg y) as Y0.
  pose proof (sin2_cos2 phi) as E. unfold Rsqr in E.
  replace (dist2 x y) with (norm2 x + norm2 y - 2 * dot x y) by vring.
  rewrite X, <- Y. pose proof (Rle_0_sqr (norm y - k * cos phi)) as Q. unfold Rsqr in Q.
  assert (k * k * (sin phi * sin phi) = k * k * (1 - cos phi * cos phi)) by (rewrite <- E; ring).
  nra.
Qed.

(** Faces at a common edge: 1.5 h, from h <= (2/3) d_f; this is the definition of h in
    step (4), together with [DihedralGap.dihedral_gap]. *)
Theorem margin_edge_separation alpha : h <= 2 / 3 * (2 * d * sin (alpha / 2)) ->
  3 / 2 * h <= 2 * d * sin (alpha / 2).
Proof. lra. Qed.

(** Box bulge <= 0.253 h. *)
Theorem margin_box_bulge w : 0 <= w <= 3 / 2 * h -> box_bulge w d <= 253 / 1000 * h.
Proof.
  intros [Hw Hws]. pose proof margin_offset as D. destruct P as (_ & _ & _ & _ & Hh).
  unfold box_bulge. destruct (box_diagonal w d) as [S0 SS].
  set (s := sqrt (w * w + d * d)) in *.
  assert (W : w * w <= 9 / 4 * (h * h)) by nra.
  assert (s <= d + 506 / 1000 * h) by (apply sq_le; nra). lra.
Qed.

(** Spoke bulge r / cos a - r cos a <= 0.074 h for chords 2 r sin a <= 3h/2. *)
Theorem margin_spoke_bulge a : 0 <= a <= PI / 4 -> 2 * r * sin a <= 3 / 2 * h ->
  r / cos a - r * cos a <= 74 / 1000 * h.
Proof.
  intros Ha Hb. pose proof margin_radius as MR. destruct P as (Hr & _ & _ & _ & Hh). pose proof PI_RGT_0.
  assert (C : 0 < cos a) by (apply cos_gt_0; lra).
  assert (S : 0 <= sin a) by (apply sin_ge_0; lra).
  pose proof (sin2_cos2 a) as E. unfold Rsqr in E.
  assert (S1 : r * sin a <= 3 / 4 * h) by lra.
  assert (S2 : sin a <= 98169 / 1000000) by nra.
  assert (C2 : 99516 / 100000 <= cos a) by (apply sq_le; nra).
  assert (K : (r / cos a - r * cos a) * cos a = r * sin a * sin a).
  { replace ((r / cos a - r * cos a) * cos a) with (r * (1 - cos a * cos a)) by (field; lra).
    rewrite <- E. ring. }
  set (z := r / cos a - r * cos a) in *.
  assert (r * sin a * sin a <= 3 / 4 * h * (98169 / 1000000)) by (apply Rmult_le_compat; nra).
  nra.
Qed.

(** Chew clearance >= 0.661 h is [ChewClearance.chew_clearance_own_subdivision]. *)

(** beta stays below 2/3 of half the angle, so T cells of neighbouring edges are
    disjoint and every remaining arc is at least phi/3 long. *)
Theorem margin_remaining_arc theta : phi <= theta -> phi / 3 <= theta - 2 * beta.
Proof. destruct P as (_ & _ & -> & _). intros. lra. Qed.
End Margins2.

(** Section 2.2 / table of section 1: from b <= 1.5 h alone (apex angle < 3 phi/4 <= 3 pi/16)
    the spoke bulge is at most 0.2276 h. *)
Theorem spoke_bulge_from_chord_alone b a h : 0 < h -> 0 < b <= 3 / 2 * h -> 0 < a <= 3 * (PI / 16) ->
  bulge b (b / 2 * (cos a / sin a)) <= 2276 / 10000 * h.
Proof.
  intros Hh Hb Ha. pose proof PI_RGT_0. rewrite isosceles_bulge by lra.
  (* cos(3 pi/16) = 4 c^3 - 3 c at c = cos(pi/16), and c by halving pi/4 *)
  assert (C8 : 923879 / 1000000 <= cos (PI / 4 / 2)).
  { apply cos_half_ge with (c := 707106 / 1000000); try lra.
    rewrite cos_PI4. assert (Q : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
    assert (Q0 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
    assert (1 / sqrt 2 * sqrt 2 = 1) by (field; lra).
    assert (sqrt 2 <= 14142136 / 10000000) by nra. nra. }
  assert (C16 : 980784 / 1000000 <= cos (PI / 16)).
  { replace (PI / 16) with (PI / 4 / 2 / 2) by field.
    apply cos_half_ge with (c := 923879 / 1000000); try lra. }
  assert (CA : 8314 / 10000 <= cos a).
  { apply Rle_trans with (cos (3 * (PI / 16))); [|apply cos_decr_1; lra].
    replace (3 * (PI / 16)) with (2 * (PI / 16) + PI / 16) by ring.
    rewrite cos_plus, cos_2a_cos, sin_2a.
    pose proof (sin2_cos2 (PI / 16)) as E. unfold Rsqr in E.
    set (c := cos (PI / 16)) in *. set (s := sin (PI / 16)) in *.
    replace ((2 * c * c - 1) * c - 2 * s * c * s) with (c * (4 * (c * c) - 3)) by nra. nra. }
  assert (C2 : 0 < cos (a / 2)) by (apply cos_gt_0; lra).
  assert (S2 : 0 < sin (a / 2)) by (apply sin_gt_0; lra).
  assert (E : cos a = 2 * cos (a / 2) * cos (a / 2) - 1).
  { replace a with (2 * (a / 2)) at 1 by field. apply cos_2a_cos. }
  pose proof (sin2_cos2 (a / 2)) as E2. unfold Rsqr in E2.
  unfold tan. set (s := sin (a / 2)) in *. set (c := cos (a / 2)) in *.
  assert (T : s <= 303416 / 1000000 * c) by (apply sq_le; nra).
  assert (T2 : s / c <= 303416 / 1000000).
  { apply Rmult_le_reg_r with c; [lra|]. replace (s / c * c) with s by (field; lra). lra. }
  assert (0 < s / c) by (apply Rdiv_lt_0_compat; lra). nra.
Qed.

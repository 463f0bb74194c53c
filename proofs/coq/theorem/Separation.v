(** How far points carried by one simplex are from the faces that share a corner or an
    edge with it: theory.md section 3, "Margins". *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins DihedralGap EdgeFaceAngle.
From Confidel.theorem Require Import Complex Placement FaceGeometry.
Import ListNotations.
Open Scope R_scope.

Section Separation.
Variables (K : complex) (r phi beta d h alpha : R).
Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.

(** The numbers, once. *)
Lemma numbers : 0 < r /\ 0 < phi <= PI / 4 /\ beta = phi / 3 /\ d = r * sin beta /\ 0 < h /\
  0 < beta < PI / 2 /\ 0 < d /\ 1978 / 1000 * h <= d /\ 764 / 100 * h <= r /\
  52 / 10 * h <= r * cos beta * sin phi /\ 2 * d <= r * cos beta * sin phi /\
  965925 / 1000000 <= cos beta < 1 /\ 0 < sin phi < 1 /\ 0 < cos phi < cos beta /\ d <= r * cos beta /\ d < r.
Proof.
  destruct HS as [P _ _]. pose proof PI_RGT_0.
  pose proof (margin_offset _ _ _ _ _ P). pose proof (margin_radius _ _ _ _ _ P).
  pose proof (margin_vertex_separation _ _ _ _ _ P). pose proof (margin_offset_separation _ _ _ _ _ P).
  pose proof (beta_is_4y _ _ _ _ _ P) as B4.
  destruct P as (Hr & Hp & EB & ED & Hh).
  pose proof (cos_4y phi (phi / 12) Hp eq_refl) as C4. rewrite <- B4 in C4.
  assert (0 < sin phi) by (apply sin_gt_0; lra).
  assert (0 < cos phi) by (apply cos_gt_0; lra).
  assert (cos phi < cos beta) by (apply cos_decreasing_1; lra).
  pose proof (sin2_cos2 phi) as E. unfold Rsqr in E.
  assert (sin phi < 1) by nra.
  assert (r * cos beta * sin phi <= r * cos beta) by nra.
  assert (r * cos beta < r) by nra.
  repeat split; try assumption; try lra.
Qed.

Ltac numbers := destruct numbers as
  (Nr & Np & Nb & Nd & Nh & Nbr & Nd0 & Ndh & Nrh & Nsep & Nsep2 & Ncb & Nsp & Ncp & Ndm & Ndr).

Lemma tri_distinct v w z : has K (Tri v w z) -> v <> w /\ v <> z /\ w <> z.
Proof.
  intros H. repeat split; apply (proper_seg K HK).
  - apply (closed_seg K HK v w z), H.
  - apply (closed_seg K HK v z w). revert H. simpl. tauto.
  - apply (closed_seg K HK w z v). revert H. simpl. tauto.
Qed.

Lemma frame_of v w z : has K (Tri v w z) -> exists zx zy, frame v w z (dir v w) (offset v w z) zx zy.
Proof. intros H. apply face_frame, (proper_tri K HK), H. Qed.

Lemma carrier_contains t x : has K t -> placed r beta d t x -> in_simplex t x.
Proof. intros H P. numbers. eapply placed_in_simplex; try eassumption. nra. Qed.

(** A carrier without the corner v keeps the distance 3r from v. *)
Lemma far_from_corner v t x : has K (Pt v) -> has K t -> placed r beta d t x -> ~ In v (corners t) ->
  3 * r <= dist v x.
Proof.
  intros Hv Ht P N. apply (feature_distance K r phi alpha HF (Pt v) t); try assumption.
  - intros c [<-|[]]. exact N.
  - reflexivity.
  - apply carrier_contains; assumption.
Qed.

(** Two faces with a common corner: they share only it, or an edge. *)
Lemma two_faces_at v w z p q : has K (Tri v w z) -> has K (Tri v p q) -> ~ incl [v; p; q] [v; w; z] ->
  meet_only_at v (Tri v w z) (Tri v p q) \/
  exists e g z', same_tri v w z v e g /\ same_tri v p q v e z' /\ z' <> g.
Proof.
  intros H G N. destruct (tri_distinct _ _ _ H) as (V1 & V2 & V3). destruct (tri_distinct _ _ _ G) as (W1 & W2 & W3).
  destruct (classic (p = w)) as [->|P1].
  { right. exists w, z, q. split; [unfold same_tri; tauto|]. split; [unfold same_tri; tauto|].
    intros ->. apply N. intros c Hc. exact Hc. }
  destruct (classic (q = z)) as [->|Q1].
  { right. exists z, w, p. split; [unfold same_tri; tauto|]. split; [unfold same_tri; tauto|]. exact P1. }
  destruct (classic (p = z)) as [->|P2].
  { right. exists z, w, q. split; [unfold same_tri; tauto|]. split; [unfold same_tri; tauto|].
    intros ->. apply N. intros c. simpl. tauto. }
  destruct (classic (q = w)) as [->|Q2].
  { right. exists w, z, p. split; [unfold same_tri; tauto|]. split; [unfold same_tri; tauto|]. exact P2. }
  left. split; [simpl; tauto|]. split; [simpl; tauto|].
  intros c [<-|[<-|[<-|[]]]] C; [reflexivity| |]; exfalso;
    destruct C as [C|[C|[C|[]]]]; congruence.
Qed.

(** An edge with a common corner that is not an edge of the face meets it only there. *)
Lemma edge_and_face_at v w z w' : has K (Tri v w z) -> has K (Seg v w') -> ~ incl [v; w'] [v; w; z] ->
  meet_only_at v (Tri v w z) (Seg v w').
Proof.
  intros H G N. destruct (tri_distinct _ _ _ H) as (V1 & V2 & V3).
  split; [simpl; tauto|]. split; [simpl; tauto|].
  intros c C [<-|[<-|[]]]; [reflexivity|]. exfalso. apply N. intros y [<-|[<-|[]]]; [simpl; tauto|exact C].
Qed.

(** Point of an edge at v, seen from v. *)
Lemma edge_point v w' x : placed r beta d (Seg v w') x -> has K (Seg v w') ->
  exists k, r * cos beta <= k /\ 0 < k /\ vsub x v = vscale k (dir v w') /\ norm2 (dir v w') = 1.
Proof.
  intros (k & Hk & ->) H. numbers. exists k. assert (0 < r * cos beta) by nra.
  repeat split; try lra.
  - generalize v (dir v w'). intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring.
  - apply dir_norm2, (proper_seg K HK), H.
Qed.

Lemma dir_in_sector v w' k : has K (Seg v w') -> 0 <= k -> sector v (Seg v w') (vscale k (dir v w')).
Proof.
  intros H Hk. pose proof (proper_seg K HK _ _ H) as N. exists 0, (k / dist v w').
  assert (L : 0 < dist v w').
  { rewrite dist_sym. apply norm_pos. intros Z. apply N. destruct v, w'.
    unfold vsub, vzero in Z; simpl in Z. injection Z. intros. f_equal; lra. }
  split; [lra|]. split; [unfold Rdiv; apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat, L]|].
  rewrite (dir_scale v w' N).
  assert (E : k = k / dist v w' * dist v w') by (field; lra). set (q := k / dist v w') in *. rewrite E.
  generalize v (dir v w') (dist v w'). intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring.
Qed.

(** The link angle against a unit vector of a face. *)
Lemma edge_angle v w z w' y : has K (Tri v w z) -> has K (Seg v w') -> ~ incl [v; w'] [v; w; z] ->
  sector v (Tri v w z) y -> dot (dir v w') y <= norm y * cos phi.
Proof.
  intros H G N Y. pose proof (edge_and_face_at _ _ _ _ H G N) as M.
  pose proof (feature_link K r phi alpha HF v _ _ y (vscale 1 (dir v w')) H G M Y
    (dir_in_sector v w' 1 G ltac:(lra))) as L.
  assert (N1 : norm (vscale 1 (dir v w')) = 1).
  { rewrite norm_scale. unfold norm. rewrite dir_norm2 by (apply (proper_seg K HK), G).
    rewrite sqrt_1, Rabs_R1. ring. }
  rewrite N1, dot_scale_r, (dot_comm y) in L. lra.
Qed.

(** Faces that share an edge: d_f >= 3h/2 apart outside their buffers. *)
Lemma shared_edge_gap v w z z' x Yx Yy : has K (Tri v w z) -> has K (Tri v w z') -> z' <> z ->
  placed r beta d (Tri v w z') x -> d <= Yy ->
  9 / 4 * (h * h) <= dist2 (vsub x v) (vadd (vscale Yx (dir v w)) (vscale Yy (offset v w z))).
Proof.
  intros H G N P HY. numbers. destruct (frame_of _ _ _ H) as (zx & zy & F). destruct (frame_of _ _ _ G) as (zx' & zy' & F').
  destruct (placed_frame r beta d v w z' _ _ _ _ x F' P) as (X & Y & D & E & _).
  rewrite E, dist2_sym. destruct HS as [_ A G2].
  eapply Rle_trans; [|apply dihedral_gap_general with (a := alpha); try lra;
    [apply (fr_u _ _ _ _ _ _ _ F)|apply (fr_o _ _ _ _ _ _ _ F)|apply (fr_o _ _ _ _ _ _ _ F')
    |apply (fr_uo _ _ _ _ _ _ _ F)|apply (fr_uo _ _ _ _ _ _ _ F')
    |apply (feature_dihedral K r phi alpha HF); [exact H|exact G|congruence]]].
  set (s := sin (alpha / 2)) in *.
  assert ((3 / 2 * h) * (3 / 2 * h) <= (2 * d * s) * (2 * d * s)) by (apply sq_le_mono; lra).
  assert (0 <= s * s) by nra. assert (d * d <= Yy * Y) by (apply Rmult_le_compat; lra).
  assert (d * d * (s * s) <= Yy * Y * (s * s)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Lemma sin_between t theta : beta <= t -> t <= theta - beta -> theta < PI -> sin beta <= sin t.
Proof.
  intros H1 H2 H3. numbers. destruct (Rle_lt_dec t (PI / 2)) as [L|L].
  - apply sin_incr_1; lra.
  - rewrite <- (sin_PI_x t). apply sin_incr_1; lra.
Qed.

(** An arc point of a face is at least 3h/2 away from every point carried by another
    face at v. *)
Lemma arc_vs_face v w z theta t p q x : has K (Tri v w z) -> corner_angle v w z theta ->
  beta <= t <= theta - beta -> has K (Tri v p q) -> ~ incl [v; p; q] [v; w; z] ->
  placed r beta d (Tri v p q) x -> 9 / 4 * (h * h) <= dist2 (vsub x v) (arc_vec r v w z t).
Proof.
  intros H A Ht G N P. numbers. destruct (frame_of _ _ _ H) as (zx & zy & F).
  pose proof A as [Tr _].
  destruct (two_faces_at _ _ _ _ _ H G N) as [M|(e & g & z' & S1 & S2 & NE)].
  - (* only the corner is shared: the link angle *)
    rewrite dist2_sym.
    assert (SX : sector v (Tri v p q) (vsub x v)) by (apply in_simplex_sector; apply P).
    assert (SY : sector v (Tri v w z) (arc_vec r v w z t)).
    { rewrite (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_in_sector v w z _ _ zx zy theta); try assumption; lra. }
    pose proof (feature_link K r phi alpha HF v _ _ _ _ H G M SY SX) as L.
    apply Rle_trans with ((r * sin phi) * (r * sin phi)).
    + assert (3 / 2 * h <= r * sin phi) by nra.
      assert ((3 / 2 * h) * (3 / 2 * h) <= (r * sin phi) * (r * sin phi)) by (apply sq_le_mono; lra). lra.
    + apply distance_from_angle; try lra; try exact L.
      rewrite (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_norm2 v w z _ _ zx zy F).
  - (* an edge ve is shared *)
    pose proof (same_tri_has K _ _ _ _ _ _ S1 H) as H'. pose proof (same_tri_has K _ _ _ _ _ _ S2 G) as G'.
    pose proof (placed_perm _ _ _ _ _ _ _ _ _ _ S2 P) as P'.
    destruct (tri_distinct _ _ _ H) as (V1 & V2 & V3).
    assert (C : (e = w /\ g = z) \/ (e = z /\ g = w)).
    { unfold same_tri in S1. repeat destruct S1 as [S1|S1]; destruct S1 as (X1 & X2 & X3); try tauto; congruence. }
    destruct C as [[-> ->]|[-> ->]].
    + unfold arc_vec. apply (shared_edge_gap v w z z'); try assumption.
      rewrite Nd. apply Rmult_le_compat_l; [lra|]. apply (sin_between t theta); lra.
    + rewrite (arc_vec_eq _ _ _ _ _ _ _ F), (arc_other _ _ theta r t).
      destruct (other_frame v w z _ _ zx zy theta F A) as (wx & wy & F2).
      destruct (frame_unique _ _ _ _ _ _ _ F2) as [<- <-].
      apply (shared_edge_gap v z w z'); try assumption.
      rewrite Nd. apply Rmult_le_compat_l; [lra|]. apply (sin_between (theta - t) theta); lra.
Qed.
End Separation.

(** Plane geometry of one face at one corner: arc points lie in the face's sector and
    keep the distance d from BOTH edges at the corner. *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.lemmas Require Import Space Margins EdgeFaceAngle.
From Confidel.theorem Require Import Complex Placement.
Import ListNotations.
Open Scope R_scope.

(** A face's corner angle exists. *)
Lemma corner_angle_exists v w z : cross (vsub w v) (vsub z v) <> vzero -> exists theta, corner_angle v w z theta.
Proof.
  intros N. destruct (face_frame v w z N) as (zx & zy & F). destruct F as [U O UO W Z ZY L].
  set (u := dir v w) in *. set (o := offset v w z) in *.
  assert (N2 : dist v z * dist v z = zx * zx + zy * zy).
  { rewrite dist_sqr, dist2_sym. unfold dist2. rewrite Z. apply dot_frame; assumption. }
  assert (M0 : 0 < dist v z).
  { pose proof (dist_nonneg v z) as N0. assert (0 < zy * zy) by nra. pose proof (Rle_0_sqr zx). unfold Rsqr in *.
    destruct (Rle_lt_or_eq_dec 0 _ N0) as [P|P]; [exact P|]. rewrite <- P in N2. lra. }
  set (M := dist v z) in *. set (q := zx / M).
  assert (QE : q * M = zx) by (unfold q; field; lra).
  assert (Q2 : q * q < 1).
  { assert (q * q * (M * M) = zx * zx) by (rewrite <- QE; ring).
    assert (0 < zy * zy) by nra. assert (0 < M * M) by nra. nra. }
  assert (Q : -1 < q < 1) by (split; nra).
  exists (acos q). pose proof PI_RGT_0.
  assert (C : cos (acos q) = q) by (apply cos_acos; lra).
  pose proof (acos_bound q) as AB.
  assert (A : 0 < acos q < PI).
  { split.
    - destruct (Req_dec (acos q) 0) as [E|E]; [rewrite E, cos_0 in C; lra|lra].
    - destruct (Req_dec (acos q) PI) as [E|E]; [rewrite E, cos_PI in C; lra|lra]. }
  assert (S : sin (acos q) * M = zy).
  { assert (0 < sin (acos q)) by (apply sin_gt_0; lra). pose proof (sin2_cos2 (acos q)) as E. unfold Rsqr in E.
    rewrite C in E. set (s := sin (acos q)) in *.
    assert ((s * M) * (s * M) = zy * zy) by nra. assert (0 < s * M) by nra. nra. }
  split; [exact A|]. fold u o M. rewrite C, Z, <- S, <- QE.
  generalize u o. intros. apply vec_eq; unfold vadd, vscale; simpl; ring.
Qed.

Section Corner.
Variables (v w z u o : vec) (zx zy theta : R).
Hypothesis F : frame v w z u o zx zy.
Hypothesis A : corner_angle v w z theta.

Let U := fr_u _ _ _ _ _ _ _ F.
Let O := fr_o _ _ _ _ _ _ _ F.
Let UO := fr_uo _ _ _ _ _ _ _ F.

Lemma theta_pos : 0 < sin theta.
Proof. destruct A as [T _]. apply sin_gt_0; lra. Qed.

Lemma z_polar : vsub z v = vscale (dist v z) (vadd (vscale (cos theta) u) (vscale (sin theta) o)).
Proof. destruct (frame_unique _ _ _ _ _ _ _ F) as [<- <-]. apply A. Qed.

Lemma z_dist_pos : 0 < dist v z.
Proof.
  pose proof z_polar as Z. destruct (Rle_lt_or_eq_dec 0 (dist v z) (dist_nonneg v z)) as [L|E]; [exact L|].
  exfalso. rewrite <- E in Z. pose proof (fr_zy _ _ _ _ _ _ _ F) as ZY.
  assert (K : zy = dot o (vsub z v)).
  { rewrite (fr_z _ _ _ _ _ _ _ F). symmetry. apply dot_frame; assumption. }
  rewrite Z, dot_scale_r in K. lra.
Qed.

(** The frame of the same face at the corner's other edge. *)
Lemma other_frame : exists wx wy,
  frame v z w (vadd (vscale (cos theta) u) (vscale (sin theta) o))
              (vadd (vscale (sin theta) u) (vscale (- cos theta) o)) wx wy.
Proof.
  pose proof (sin2_cos2 theta) as E. unfold Rsqr in E. pose proof theta_pos as S.
  exists (dist v w * cos theta), (dist v w * sin theta).
  pose proof (dot_frame u o (cos theta) (sin theta) U O UO) as (D1 & D2 & D3).
  pose proof (dot_frame u o (sin theta) (- cos theta) U O UO) as (D4 & D5 & D6).
  constructor.
  - rewrite D3. lra.
  - rewrite D6. lra.
  - rewrite dot_add_l, !dot_scale_l, D4, D5. ring.
  - apply z_polar.
  - rewrite (fr_w _ _ _ _ _ _ _ F). generalize (dist v w). intros L.
    transitivity (vscale (L * (sin theta * sin theta + cos theta * cos theta)) u).
    + rewrite E. generalize u. intros. apply vec_eq; unfold vscale; simpl; ring.
    + generalize u o. intros. apply vec_eq; unfold vadd, vscale; simpl; ring.
  - apply Rmult_lt_0_compat; [apply (fr_w0 _ _ _ _ _ _ _ F)|exact S].
  - apply z_dist_pos.
Qed.

Definition arc r t := vadd (vscale (r * cos t) u) (vscale (r * sin t) o).

Lemma arc_vec_eq r t : arc_vec r v w z t = arc r t.
Proof. unfold arc_vec, arc. destruct (frame_unique _ _ _ _ _ _ _ F) as [-> ->]. reflexivity. Qed.

Lemma arc_norm2 r t : norm2 (arc r t) = r * r.
Proof.
  unfold arc. destruct (dot_frame u o (r * cos t) (r * sin t) U O UO) as (_ & _ & ->).
  pose proof (sin2_cos2 t) as E. unfold Rsqr in E.
  transitivity (r * r * (sin t * sin t + cos t * cos t)); [ring|rewrite E; ring].
Qed.

(** Seen from the other edge the angle is theta - t. *)
Lemma arc_other r t : arc r t =
  vadd (vscale (r * cos (theta - t)) (vadd (vscale (cos theta) u) (vscale (sin theta) o)))
       (vscale (r * sin (theta - t)) (vadd (vscale (sin theta) u) (vscale (- cos theta) o))).
Proof.
  pose proof (sin2_cos2 theta) as E. unfold Rsqr in E.
  assert (C : cos t = cos (theta - t) * cos theta + sin (theta - t) * sin theta).
  { replace t with (theta - (theta - t)) at 1 by ring. rewrite cos_minus. ring. }
  assert (S : sin t = sin theta * cos (theta - t) - cos theta * sin (theta - t)).
  { replace t with (theta - (theta - t)) at 1 by ring. apply sin_minus. }
  unfold arc. rewrite C, S. generalize u o (cos (theta - t)) (sin (theta - t)). intros.
  apply vec_eq; unfold vadd, vscale; simpl; ring.
Qed.

(** Arc points point into the face. *)
Lemma arc_in_sector r t : 0 <= r -> 0 <= t <= theta -> sector v (Tri v w z) (arc r t).
Proof.
  intros Hr Ht. pose proof theta_pos as S. pose proof z_dist_pos as M. pose proof (fr_w0 _ _ _ _ _ _ _ F) as L.
  destruct A as [T _].
  assert (S1 : 0 <= sin (theta - t)) by (apply sin_ge_0; lra).
  assert (S2 : 0 <= sin t) by (apply sin_ge_0; lra).
  exists 0, (r * sin (theta - t) / (sin theta * dist v w)), (r * sin t / (sin theta * dist v z)).
  split; [lra|]. split; [|split].
  - unfold Rdiv. apply Rmult_le_pos; [nra|]. apply Rlt_le, Rinv_0_lt_compat. nra.
  - unfold Rdiv. apply Rmult_le_pos; [nra|]. apply Rlt_le, Rinv_0_lt_compat. nra.
  - rewrite (fr_w _ _ _ _ _ _ _ F), z_polar. unfold arc.
    assert (C : r * cos t = r * sin (theta - t) / (sin theta * dist v w) * dist v w
       + r * sin t / (sin theta * dist v z) * dist v z * cos theta).
    { rewrite sin_minus. field. lra. }
    assert (D : r * sin t = r * sin t / (sin theta * dist v z) * dist v z * sin theta) by (field; lra).
    set (f := r * sin (theta - t) / (sin theta * dist v w)) in *.
    set (g := r * sin t / (sin theta * dist v z)) in *. clearbody f g.
    rewrite C, D. generalize u o v (dist v w) (dist v z).
    intros. apply vec_eq; unfold vadd, vscale, vsub; simpl; ring.
Qed.
End Corner.

(** The corner angle is at least phi. *)
Lemma corner_angle_ge K r phi alpha v w z theta : simplicial K -> features K r phi alpha ->
  has K (Tri v w z) -> 0 < phi <= PI / 4 -> corner_angle v w z theta -> phi <= theta.
Proof.
  intros S Ft H Hp A.
  destruct (face_frame v w z (proper_tri K S _ _ _ H)) as (zx & zy & F).
  set (u := dir v w) in *. set (o := offset v w z) in *.
  assert (H1 : has K (Seg v w)) by (apply (closed_seg K S v w z), H).
  assert (H2 : has K (Seg v z)).
  { apply (closed_seg K S v z w). revert H. simpl. tauto. }
  assert (V1 := proper_seg K S _ _ H1). assert (V2 := proper_seg K S _ _ H2).
  assert (V3 : w <> z).
  { apply (proper_seg K S). apply (closed_seg K S w z v). revert H. simpl. tauto. }
  assert (M : meet_only_at v (Seg v w) (Seg v z)).
  { split; [simpl; tauto|]. split; [simpl; tauto|]. intros c [<-|[<-|[]]]; [reflexivity|].
    intros [E|[E|[]]]; congruence. }
  pose proof (feature_link K r phi alpha Ft v _ _ (vsub w v) (vsub z v) H1 H2 M) as Lk.
  assert (L := Lk ltac:(exists 0, 1; repeat split; try lra; generalize v w; veq)
                  ltac:(exists 0, 1; repeat split; try lra; generalize v z; veq)). clear Lk.
  pose proof (z_dist_pos v w z u o zx zy theta F A) as DZ. pose proof (fr_w0 _ _ _ _ _ _ _ F) as DW.
  change (norm (vsub w v)) with (dist w v) in L. change (norm (vsub z v)) with (dist z v) in L.
  rewrite (dist_sym w v), (dist_sym z v) in L.
  rewrite (z_polar v w z u o zx zy theta F A), (fr_w _ _ _ _ _ _ _ F) in L.
  rewrite dot_scale_l, dot_scale_r in L.
  destruct (dot_frame u o (cos theta) (sin theta) (fr_u _ _ _ _ _ _ _ F) (fr_o _ _ _ _ _ _ _ F) (fr_uo _ _ _ _ _ _ _ F))
    as (D & _ & _). rewrite D in L.
  destruct A as [T _]. destruct (Rle_lt_dec phi theta) as [G|G]; [exact G|exfalso].
  assert (cos phi < cos theta) by (apply cos_decreasing_1; lra).
  set (a := dist v w) in *. set (b := dist v z) in *.
  assert (0 < a * b) by nra. assert (a * (b * cos theta) = a * b * cos theta) by ring. nra.
Qed.

(** Frame coordinates of a point carried by a face: a height of at least d. *)
Lemma placed_frame r beta d v w z u o zx zy x : frame v w z u o zx zy ->
  placed r beta d (Tri v w z) x ->
  exists X Y, d <= Y /\ vsub x v = vadd (vscale X u) (vscale Y o) /\ r <= dist v x.
Proof.
  intros F [I P]. destruct (P v w z) as [B D]; [unfold same_tri; tauto|].
  destruct (frame_coords v w z u o zx zy x F) as (X & Y & _ & E).
  { apply in_simplex_sector. exact I. }
  exists X, Y. repeat split; try assumption.
  destruct (frame_unique _ _ _ _ _ _ _ F) as [_ EO]. rewrite EO, E in D.
  destruct (dot_frame u o X Y (fr_u _ _ _ _ _ _ _ F) (fr_o _ _ _ _ _ _ _ F) (fr_uo _ _ _ _ _ _ _ F)) as (_ & K & _).
  lra.
Qed.

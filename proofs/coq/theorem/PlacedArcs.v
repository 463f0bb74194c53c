(** The construction's arc points are placed; what is to show is their distance from the
    line of the opposite edge. *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins.
From Confidel.theorem Require Import Complex Placement FaceGeometry Separation OffFaceVertex PlacedPoints.
Import ListNotations.
Open Scope R_scope.

Section PlacedArcs.
Variables (K : complex) (r phi beta d h alpha : R).
Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.

Ltac numbers := destruct (numbers r phi beta d h alpha HS) as
  (Nr & Np & Nb & Nd & Nh & Nbr & Nd0 & Ndh & Nrh & Nsep & Nsep2 & Ncb & Nsp & Ncp & Ndm & Ndr).

(** Feature distance of a corner from the opposite edge and from another corner. *)
Lemma corner_to_edge v w z q : has K (Tri v w z) -> on_segment w z q -> 3 * r <= dist v q.
Proof.
  intros H Q. destruct (tri_distinct K HK _ _ _ H) as (V1 & V2 & V3).
  apply (feature_distance K r phi alpha HF (Pt v) (Seg w z)).
  - apply (corner_has K HK v w z), H.
  - apply (closed_seg K HK w z v), has_tri_cycle, H.
  - intros c [<-|[]] [J|[J|[]]]; congruence.
  - reflexivity.
  - exact Q.
Qed.
Lemma corner_to_corner v w z : has K (Tri v w z) -> 3 * r <= dist v w.
Proof. intros H. apply (corner_to_edge v w z); [exact H|]. exists 0. split; [lra|]. generalize w z. veq. Qed.

(** The planar fact: apex (a, H) over a base from 0 to L, angle at least phi at the apex,
    base points at least m away: H >= m sin phi, even when the foot misses the base. *)
Lemma apex_height a H L m sphi cphi : 0 < H -> 0 < L -> 0 < m -> 0 < sphi < 1 -> 0 < cphi -> sphi * sphi + cphi * cphi = 1 ->
  m * m <= a * a + H * H -> m * m <= (L - a) * (L - a) + H * H -> (0 <= a <= L -> m <= H) ->
  (0 <= a * a - a * L + H * H ->
    (a * a - a * L + H * H) * (a * a - a * L + H * H) <= cphi * cphi * ((a * a + H * H) * ((L - a) * (L - a) + H * H))) ->
  m * sphi <= H.
Proof.
  intros H0 L0 M0 S C E D1 D2 IN ANG.
  assert (LAG : (a * a + H * H) * ((L - a) * (L - a) + H * H)
     - (a * a - a * L + H * H) * (a * a - a * L + H * H) = H * H * (L * L)) by ring.
  assert (FIN : forall s2, L * L <= s2 -> m * m * s2 <= (a * a + H * H) * ((L - a) * (L - a) + H * H) ->
     0 <= a * a - a * L + H * H -> m * sphi <= H).
  { intros s2 HL HP HD. specialize (ANG HD). set (Pr := (a * a + H * H) * ((L - a) * (L - a) + H * H)) in *.
    assert (X : sphi * sphi * Pr <= H * H * (L * L)) by (replace (sphi * sphi) with (1 - cphi * cphi) by lra; lra).
    assert (L2 : 0 < L * L) by nra. assert (0 <= sphi * sphi) by nra. assert (0 <= m * m) by nra.
    assert (X2 : sphi * sphi * (m * m * (L * L)) <= sphi * sphi * Pr).
    { apply Rmult_le_compat_l; [lra|]. apply Rle_trans with (m * m * s2); [apply Rmult_le_compat_l; lra|exact HP]. }
    apply sq_le; [lra|]. apply Rmult_le_reg_r with (L * L); [exact L2|].
    replace (m * sphi * (m * sphi) * (L * L)) with (sphi * sphi * (m * m * (L * L))) by ring. lra. }
  destruct (Rlt_le_dec a 0) as [A|A]; [|destruct (Rle_lt_dec a L) as [B|B]].
  - apply (FIN ((L - a) * (L - a) + H * H)).
    + assert (L * L <= (L - a) * (L - a)) by (apply sq_le_mono; lra). nra.
    + apply Rmult_le_compat_r; [nra|lra].
    + assert (0 <= - a * L) by nra. nra.
  - specialize (IN (conj A B)). nra.
  - apply (FIN (a * a + H * H)).
    + assert (L * L <= a * a) by (apply sq_le_mono; lra). nra.
    + rewrite (Rmult_comm (a * a + H * H)). apply Rmult_le_compat_r; [nra|lra].
    + assert (0 <= a * (a - L)) by nra. nra.
Qed.

Lemma corner_height v w z zx zy : has K (Tri v w z) -> frame w z v (dir w z) (offset w z v) zx zy ->
  3 * r * sin phi <= zy.
Proof.
  intros H F. numbers. destruct (tri_distinct K HK _ _ _ H) as (V1 & V2 & V3).
  set (u := dir w z) in *. set (o := offset w z v) in *. set (L := dist w z) in *.
  pose proof (fr_u _ _ _ _ _ _ _ F) as U. pose proof (fr_o _ _ _ _ _ _ _ F) as O. pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
  pose proof (fr_z _ _ _ _ _ _ _ F) as EV. pose proof (fr_w _ _ _ _ _ _ _ F) as EZ. pose proof (fr_zy _ _ _ _ _ _ _ F) as P.
  pose proof (fr_w0 _ _ _ _ _ _ _ F) as L0. fold L in EZ, L0.
  assert (NW : norm2 (vsub w v) = zx * zx + zy * zy).
  { replace (norm2 (vsub w v)) with (norm2 (vsub v w)) by vring. rewrite EV. apply dot_frame; assumption. }
  assert (EZV : vsub z v = vadd (vscale (L - zx) u) (vscale (- zy) o)).
  { replace (vsub z v) with (vsub (vsub z w) (vsub v w)) by (generalize z v w; veq). rewrite EZ, EV.
    generalize u o. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
  assert (EWV : vsub w v = vadd (vscale (- zx) u) (vscale (- zy) o)).
  { replace (vsub w v) with (vscale (-1) (vsub v w)) by (generalize v w; veq). rewrite EV.
    generalize u o. intros. apply vec_eq; unfold vadd, vscale; simpl; ring. }
  assert (NZ : norm2 (vsub z v) = (L - zx) * (L - zx) + zy * zy).
  { rewrite EZV. destruct (dot_frame u o (L - zx) (- zy) U O UO) as (_ & _ & ->). ring. }
  assert (DT : dot (vsub w v) (vsub z v) = zx * zx - zx * L + zy * zy).
  { rewrite EWV, dot_add_l, !dot_scale_l, EZV.
    destruct (dot_frame u o (L - zx) (- zy) U O UO) as (-> & -> & _). ring. }
  pose proof (sin2_cos2 phi) as E. unfold Rsqr in E.
  assert (W3 := corner_to_corner v w z H).
  assert (Z3 : 3 * r <= dist v z).
  { apply (corner_to_corner v z w). revert H. simpl. tauto. }
  apply (apex_height zx zy L (3 * r) (sin phi) (cos phi)); try assumption; try lra.
  - rewrite <- NW, norm2_of_dist. apply sq_le_mono; lra.
  - rewrite <- NZ, norm2_of_dist. apply sq_le_mono; lra.
  - intros [A B]. assert (Q : on_segment w z (vadd w (vscale zx u))).
    { exists (zx / L). assert (EL : zx / L * L = zx) by (field; lra). split.
      - set (q := zx / L) in *. nra.
      - unfold along. rewrite EZ. set (q := zx / L) in *. rewrite <- EL.
        generalize w u L. intros. apply vec_eq; unfold vadd, vscale; simpl; ring. }
    pose proof (corner_to_edge v w z _ H Q) as D.
    assert (DX : dist v (vadd w (vscale zx u)) = zy); [|lra].
    unfold dist. replace (vsub v (vadd w (vscale zx u))) with (vscale zy o).
    + rewrite norm_scale. unfold norm. rewrite O, sqrt_1, Rabs_pos_eq; lra.
    + replace (vsub v (vadd w (vscale zx u))) with (vsub (vsub v w) (vscale zx u)) by (generalize v w u; veq).
      rewrite EV. generalize u o. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring.
  - intros D0. rewrite <- NW, <- NZ, <- DT in *.
    assert (HA : has K (Seg v w)) by (apply (closed_seg K HK v w z), H).
    assert (HB : has K (Seg v z)) by (apply (closed_seg K HK v z w); revert H; simpl; tauto).
    assert (M : meet_only_at v (Seg v w) (Seg v z)).
    { split; [simpl; tauto|]. split; [simpl; tauto|]. intros c [<-|[<-|[]]]; [reflexivity|]. intros [J|[J|[]]]; congruence. }
    pose proof (feature_link K r phi alpha HF v _ _ (vsub w v) (vsub z v) HA HB M
      ltac:(exists 0, 1; repeat split; try lra; generalize v w; veq)
      ltac:(exists 0, 1; repeat split; try lra; generalize v z; veq)) as LK.
    rewrite <- (norm_sqr (vsub w v)), <- (norm_sqr (vsub z v)).
    set (p := norm (vsub w v)) in *. set (q := norm (vsub z v)) in *.
    replace (cos phi * cos phi * (p * p * (q * q))) with ((p * q * cos phi) * (p * q * cos phi)) by ring.
    apply sq_le_mono; assumption.
Qed.

Theorem arc_points_are_placed v w z theta t : has K (Tri v w z) -> corner_angle v w z theta ->
  beta <= t <= theta - beta -> placed r beta d (Tri v w z) (vadd v (arc_vec r v w z t)).
Proof.
  intros H A Ht. numbers. pose proof A as [Tr _].
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F). destruct (tri_distinct K HK _ _ _ H) as (V1 & V2 & V3).
  pose proof (fr_u _ _ _ _ _ _ _ F) as U. pose proof (fr_o _ _ _ _ _ _ _ F) as O. pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
  set (y := arc_vec r v w z t). set (x := vadd v y).
  assert (EX : vsub x v = y) by (unfold x; generalize v y; veq).
  assert (NY : norm2 y = r * r) by (unfold y; rewrite (arc_vec_eq _ _ _ _ _ _ _ F); apply (arc_norm2 v w z _ _ zx zy F)).
  assert (DV : dist v x = r).
  { rewrite dist_sym. unfold dist, norm. rewrite EX, NY. apply sqrt_square. lra. }
  assert (Hz : has K (Tri v z w)) by (revert H; simpl; tauto).
  apply placed_intro with (K := K) (phi := phi) (h := h) (alpha := alpha); try assumption.
  - exists (r * cos t), (r * sin t). rewrite EX. reflexivity.
  - lra.
  - pose proof (corner_to_corner v w z H). pose proof (dist_triangle v x w) as T. rewrite (dist_sym x w) in T. lra.
  - pose proof (corner_to_corner v z w Hz). pose proof (dist_triangle v x z) as T. rewrite (dist_sym x z) in T. lra.
  - rewrite EX. unfold y, arc_vec.
    destruct (dot_frame _ _ (r * cos t) (r * sin t) U O UO) as (_ & -> & _).
    rewrite Nd. apply Rmult_le_compat_l; [lra|]. apply (sin_between r phi beta d h alpha HS t theta); lra.
  - (* the opposite edge *)
    assert (H' : has K (Tri w z v)) by (apply has_tri_cycle, H).
    destruct (frame_of K HK _ _ _ H') as (vx' & vy' & F').
    pose proof (corner_height v w z vx' vy' H F') as CH.
    assert (SY : sector v (Tri v w z) y).
    { unfold y. rewrite (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_in_sector v w z _ _ zx zy theta); try assumption; lra. }
    destruct SY as (i0 & i & j & _ & Hi & Hj & EY).
    assert (EY' : y = vadd (vscale i (vsub w v)) (vscale j (vsub z v))).
    { rewrite EY. generalize v w z. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
    assert (IJ : 0 < i + j).
    { destruct (Rle_lt_or_eq_dec 0 (i + j) ltac:(lra)) as [L|Z]; [exact L|].
      assert (i = 0) by lra. assert (j = 0) by lra. subst i j. rewrite EY' in NY.
      assert (Z0 : norm2 (vadd (vscale 0 (vsub w v)) (vscale 0 (vsub z v))) = 0) by vring. rewrite Z0 in NY. nra. }
    (* the ray from v through x leaves the face at distance >= 3r *)
    set (s := j / (i + j)). assert (ES : s * (i + j) = j) by (unfold s; field; lra).
    assert (S01 : 0 <= s <= 1) by (split; nra).
    pose proof (corner_to_edge v w z (along w z s) H ltac:(exists s; split; [exact S01|reflexivity])) as D.
    assert (RAY : y = vscale (i + j) (vsub (along w z s) v)).
    { rewrite EY'. assert (EI : i = (1 - s) * (i + j)) by lra. unfold along.
      transitivity (vadd (vscale ((1 - s) * (i + j)) (vsub w v)) (vscale (s * (i + j)) (vsub z v))).
      - rewrite <- EI, ES. reflexivity.
      - generalize (i + j) v w z s. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
    assert (IJ3 : (i + j) * (3 * r) <= r).
    { assert (NR : norm y = r) by (unfold norm; rewrite NY; apply sqrt_square; lra).
      rewrite RAY, norm_scale, Rabs_pos_eq in NR by lra.
      change (norm (vsub (along w z s) v)) with (dist (along w z s) v) in NR. rewrite dist_sym in NR.
      rewrite <- NR at 2. apply Rmult_le_compat_l; lra. }
    assert (EW : vsub x w = vadd (vscale (1 - i - j) (vsub v w)) (vscale j (vsub z w))).
    { replace (vsub x w) with (vadd y (vsub v w)) by (unfold x; generalize v w y; veq). rewrite EY'.
      generalize v w z. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
    rewrite EW, dot_add_r, !dot_scale_r, (fr_w _ _ _ _ _ _ _ F'), (fr_z _ _ _ _ _ _ _ F'), dot_scale_r.
    rewrite (dot_comm (offset w z v) (dir w z)), (fr_uo _ _ _ _ _ _ _ F').
    destruct (dot_frame _ _ vx' vy' (fr_u _ _ _ _ _ _ _ F') (fr_o _ _ _ _ _ _ _ F') (fr_uo _ _ _ _ _ _ _ F')) as (_ & -> & _).
    assert (I3 : i + j <= 1 / 3) by nra.
    assert (2 * d <= r * sin phi) by nra.
    assert (2 / 3 * (3 * r * sin phi) <= (1 - i - j) * vy') by (apply Rmult_le_compat; nra).
    lra.
  - rewrite (offset_swap K v z w HK Hz).
    destruct (frame_of K HK _ _ _ Hz) as (wx & wy & F2).
    replace (vsub x z) with (vsub y (vsub z v)) by (unfold x; generalize v z y; veq).
    rewrite dot_sub_r, (fr_w _ _ _ _ _ _ _ F2), dot_scale_r, (dot_comm (offset v z w) (dir v z)), (fr_uo _ _ _ _ _ _ _ F2).
    unfold y. rewrite (arc_vec_eq _ _ _ _ _ _ _ F), (arc_other _ _ theta r t).
    destruct (other_frame v w z _ _ zx zy theta F A) as (wx' & wy' & F3).
    destruct (frame_unique _ _ _ _ _ _ _ F3) as [_ ->].
    destruct (dot_frame _ _ (r * cos (theta - t)) (r * sin (theta - t)) (fr_u _ _ _ _ _ _ _ F3) (fr_o _ _ _ _ _ _ _ F3) (fr_uo _ _ _ _ _ _ _ F3)) as (_ & -> & _).
    assert (sin beta <= sin (theta - t)) by (apply (sin_between r phi beta d h alpha HS (theta - t) theta); lra).
    rewrite Nd. nra.
Qed.
End PlacedArcs.

(** The construction's protectors are placed: inside their face, at distance >= d from all
    its edges and >= r from its corners. *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins.
From Confidel.theorem Require Import Complex Placement FaceGeometry Separation OffFaceVertex.
Import ListNotations.
Open Scope R_scope.

Section PlacedPoints.
Variables (K : complex) (r phi beta d h alpha : R).
Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.

Ltac numbers := destruct (numbers r phi beta d h alpha HS) as
  (Nr & Np & Nb & Nd & Nh & Nbr & Nd0 & Ndh & Nrh & Nsep & Nsep2 & Ncb & Nsp & Ncp & Ndm & Ndr).

(** Positive heights over the three edges put a point of the plane into the face. *)
Lemma placed_intro v w z x : has K (Tri v w z) -> plane_of v w z x ->
  r <= dist v x -> r <= dist w x -> r <= dist z x ->
  d <= dot (offset v w z) (vsub x v) -> d <= dot (offset w z v) (vsub x w) -> d <= dot (offset z v w) (vsub x z) ->
  placed r beta d (Tri v w z) x.
Proof.
  intros H (X & Y & E) Dv Dw Dz H1 H2 H3. numbers.
  assert (H' : has K (Tri w z v)) by (apply has_tri_cycle, H).
  assert (H'' : has K (Tri z v w)) by (apply has_tri_cycle, H').
  split.
  - destruct (frame_of K HK _ _ _ H) as (zx & zy & F). destruct (frame_of K HK _ _ _ H') as (vx' & vy' & F').
    destruct (frame_of K HK _ _ _ H'') as (wx & wy & F'').
    pose proof (fr_zy _ _ _ _ _ _ _ F) as P1. pose proof (fr_zy _ _ _ _ _ _ _ F') as P2. pose proof (fr_zy _ _ _ _ _ _ _ F'') as P3.
    pose proof (fr_w0 _ _ _ _ _ _ _ F) as L0.
    set (j := Y / zy). set (i := (X - j * zx) / dist v w).
    assert (EJ : j * zy = Y) by (unfold j; field; lra).
    assert (EI : i * dist v w = X - j * zx) by (unfold i; field; lra).
    assert (EX : vsub x v = vadd (vscale i (vsub w v)) (vscale j (vsub z v))).
    { rewrite E, (fr_w _ _ _ _ _ _ _ F), (fr_z _ _ _ _ _ _ _ F).
      replace X with (i * dist v w + j * zx) by lra. rewrite <- EJ.
      generalize (dir v w) (offset v w z) i j (dist v w). intros. apply vec_eq; unfold vadd, vscale; simpl; ring. }
    (* a frame's offset measures heights *)
    assert (HT : forall a b c cx cy, frame a b c (dir a b) (offset a b c) cx cy ->
      dot (offset a b c) (vsub b a) = 0 /\ dot (offset a b c) (vsub c a) = cy).
    { intros a b c cx cy G. rewrite (fr_w _ _ _ _ _ _ _ G), (fr_z _ _ _ _ _ _ _ G). split.
      - rewrite dot_scale_r, dot_comm, (fr_uo _ _ _ _ _ _ _ G). ring.
      - apply (dot_frame _ _ cx cy (fr_u _ _ _ _ _ _ _ G) (fr_o _ _ _ _ _ _ _ G) (fr_uo _ _ _ _ _ _ _ G)). }
    destruct (HT _ _ _ _ _ F) as [A1 A2]. destruct (HT _ _ _ _ _ F') as [B1 B2]. destruct (HT _ _ _ _ _ F'') as [C1 C2].
    rewrite EX, dot_add_r, !dot_scale_r, A1, A2 in H1.
    assert (EW : vsub x w = vadd (vscale (1 - i - j) (vsub v w)) (vscale j (vsub z w))).
    { replace (vsub x w) with (vadd (vsub x v) (vsub v w)) by (generalize x v w; veq). rewrite EX.
      generalize v w z i j. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
    assert (EZ : vsub x z = vadd (vscale i (vsub w z)) (vscale (1 - i - j) (vsub v z))).
    { replace (vsub x z) with (vadd (vsub x v) (vsub v z)) by (generalize x v z; veq). rewrite EX.
      generalize v w z i j. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
    rewrite EW, dot_add_r, !dot_scale_r, B1, B2 in H2.
    rewrite EZ, dot_add_r, !dot_scale_r, C1, C2 in H3.
    exists (1 - i - j), i, j. repeat split; try nra.
    replace x with (vadd v (vsub x v)) by (generalize x v; veq). rewrite EX.
    unfold bary3. generalize v w z i j. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring.
  - pose proof (offset_swap K v w z HK H) as S1. pose proof (offset_swap K w z v HK H') as S2. pose proof (offset_swap K z v w HK H'') as S3.
    (* the offset is orthogonal to the edge: either end will do *)
    assert (OE : forall a b c, has K (Tri a b c) -> dot (offset a b c) (vsub x b) = dot (offset a b c) (vsub x a)).
    { intros a b c G. destruct (frame_of K HK _ _ _ G) as (cx & cy & FG).
      replace (vsub x a) with (vadd (vsub x b) (vsub b a)) by (generalize x a b; veq).
      rewrite dot_add_r, (fr_w _ _ _ _ _ _ _ FG), dot_scale_r, (dot_comm (offset a b c) (dir a b)), (fr_uo _ _ _ _ _ _ _ FG). ring. }
    pose proof (OE _ _ _ H) as O1. pose proof (OE _ _ _ H') as O2. pose proof (OE _ _ _ H'') as O3.
    intros p q t S. unfold same_tri in S. repeat destruct S as [S|S]; destruct S as (-> & -> & ->); split; try assumption;
      rewrite ?S1, ?S2, ?S3; lra.
Qed.

(** Height of a protector over the neighbouring edge v z: at least r sin(theta - beta) >= d. *)
Lemma protector_over_neighbour v w z k : has K (Tri v w z) -> r * cos beta <= k ->
  d <= dot (offset v z w) (vadd (vscale k (dir v w)) (vscale d (offset v w z))).
Proof.
  intros H Hk. numbers. destruct (frame_of K HK _ _ _ H) as (zx & zy & F).
  destruct (corner_angle_exists v w z (proper_tri K HK _ _ _ H)) as (theta & A).
  pose proof (corner_angle_ge K r phi alpha v w z theta HK HF H Np A) as TH. pose proof A as [Tr _].
  destruct (other_frame v w z _ _ zx zy theta F A) as (wx & wy & F2).
  destruct (frame_unique _ _ _ _ _ _ _ F2) as [_ EO]. rewrite EO, dot_add_l, !dot_scale_l.
  destruct (dot_frame _ _ k d (fr_u _ _ _ _ _ _ _ F) (fr_o _ _ _ _ _ _ _ F) (fr_uo _ _ _ _ _ _ _ F)) as (D1 & D2 & _).
  rewrite D1, D2.
  assert (S0 : 0 < sin theta) by (apply sin_gt_0; lra).
  pose proof (sin_between r phi beta d h alpha HS (theta - beta) theta ltac:(lra) ltac:(lra) ltac:(lra)) as SB.
  rewrite sin_minus in SB.
  assert (sin theta * (r * cos beta) <= sin theta * k) by (apply Rmult_le_compat_l; lra).
  assert (r * sin beta <= r * (sin theta * cos beta - cos theta * sin beta)) by (apply Rmult_le_compat_l; lra).
  rewrite Nd in *. lra.
Qed.

Theorem protectors_are_placed v w z k : has K (Tri v w z) -> r * cos beta <= k <= dist v w - r * cos beta ->
  placed r beta d (Tri v w z) (vadd v (vadd (vscale k (dir v w)) (vscale d (offset v w z)))).
Proof.
  intros H [K1 K2]. numbers.
  set (u := dir v w) in *. set (o := offset v w z) in *. set (y := vadd (vscale k u) (vscale d o)). set (x := vadd v y).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F). destruct (tri_distinct K HK _ _ _ H) as (V1 & V2 & V3).
  fold u in F. fold o in F.
  pose proof (fr_u _ _ _ _ _ _ _ F) as U. pose proof (fr_o _ _ _ _ _ _ _ F) as O. pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
  assert (EX : vsub x v = y) by (unfold x; generalize v y; veq).
  assert (H' : has K (Tri w v z)) by (apply has_tri_swap, H).
  (* seen from w *)
  assert (EW : vsub x w = vadd (vscale (dist v w - k) (dir w v)) (vscale d (offset w v z))).
  { rewrite (offset_swap K v w z HK H), (dir_opposite v w). fold u o.
    replace (vsub x w) with (vsub y (vsub w v)) by (unfold x; generalize v w y; veq).
    rewrite (fr_w _ _ _ _ _ _ _ F). unfold y. generalize u o (dist v w). intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
  pose proof (sin2_cos2 beta) as E. unfold Rsqr in E.
  assert (B : forall q, r * cos beta <= q -> r * r <= q * q + d * d).
  { intros q Hq. assert ((r * cos beta) * (r * cos beta) <= q * q) by (apply sq_le_mono; nra). rewrite Nd.
    replace (r * r) with (r * r * (sin beta * sin beta + cos beta * cos beta)) by (rewrite E; ring). lra. }
  apply placed_intro; try assumption.
  - exists k, d. rewrite EX. reflexivity.
  - apply sq_le; [apply dist_nonneg|]. rewrite <- norm2_of_dist, EX. unfold y.
    destruct (dot_frame u o k d U O UO) as (_ & _ & ->). apply B, K1.
  - destruct (frame_of K HK _ _ _ H') as (zx' & zy' & F').
    apply sq_le; [apply dist_nonneg|]. rewrite <- norm2_of_dist, EW.
    destruct (dot_frame _ _ (dist v w - k) d (fr_u _ _ _ _ _ _ _ F') (fr_o _ _ _ _ _ _ _ F') (fr_uo _ _ _ _ _ _ _ F')) as (_ & _ & ->).
    apply B. lra.
  - (* the corner z is 3r away from the edge, the protector only d *)
    assert (Hz : has K (Pt z)) by (apply (corner_has K HK z v w); do 2 apply has_tri_cycle; exact H).
    assert (HE : has K (Seg v w)) by (apply (closed_seg K HK v w z), H).
    assert (PE : placed r beta d (Seg v w) (vadd v (vscale k u))) by (exists k; split; [lra|reflexivity]).
    assert (D3 : 3 * r <= dist z (vadd v (vscale k u))).
    { apply (far_from_corner K r phi beta d h alpha HK HF HS z (Seg v w)); try assumption.
      intros [J|[J|[]]]; congruence. }
    pose proof (dist_triangle z x (vadd v (vscale k u))) as T.
    assert (DX : dist x (vadd v (vscale k u)) = d).
    { unfold dist. replace (vsub x (vadd v (vscale k u))) with (vscale d o).
      - rewrite norm_scale. unfold norm. rewrite O, sqrt_1, Rabs_pos_eq; lra.
      - unfold x, y. generalize v u o. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
    lra.
  - rewrite EX. unfold y. fold o. destruct (dot_frame u o k d U O UO) as (_ & -> & _). lra.
  - rewrite EW. apply protector_over_neighbour; [exact H'|lra].
  - (* over z v: the same height as over v z *)
    assert (Hz : has K (Tri v z w)) by (revert H; simpl; tauto).
    rewrite (offset_swap K v z w HK Hz).
    destruct (frame_of K HK _ _ _ Hz) as (wx & wy & F2).
    replace (vsub x z) with (vsub y (vsub z v)) by (unfold x; generalize v z y; veq).
    rewrite dot_sub_r, (fr_w _ _ _ _ _ _ _ F2), dot_scale_r, (dot_comm (offset v z w) (dir v z)), (fr_uo _ _ _ _ _ _ _ F2).
    pose proof (protector_over_neighbour v w z k H K1) as PO. fold u o y in PO. lra.
Qed.
End PlacedPoints.

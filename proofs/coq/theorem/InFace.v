(** The cells of a face against the points of the same face. What a cell must know of
    them is its legality: consecutive on its arc or row, with Chew's points farther than h/2
    away (L8), or Delaunay in the plane for C. *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins EdgeFaceAngle VertexCells EdgeCells.
From Confidel.theorem Require Import Complex Placement FaceGeometry Separation OffFaceVertex OffFaceEdge.
Import ListNotations.
Open Scope R_scope.

(** Points with their carriers. *)
Definition point_set := simplex -> vec -> Prop.

(** x keeps the distance h/2 from the segment pq. *)
Definition clear_of h p q x := forall t, 0 <= t <= 1 -> h / 2 < dist x (along p q t).

(** S is legal if every point of its face is outside its sector or clear of its chord. *)
Definition S_legal (P : point_set) r h v w z t1 t2 := forall a b c x, same_tri v w z a b c -> P (Tri a b c) x ->
  dot (arc_vec 1 v w z ((t1 + t2) / 2)) (vsub x v) <= norm (vsub x v) * cos ((t2 - t1) / 2) \/
  clear_of h (vadd v (arc_vec r v w z t1)) (vadd v (arc_vec r v w z t2)) x.

(** R is legal if no row point is between its ends, and every point of its face is beside it
    or clear of its side on the protector. *)
Definition R_legal (P : point_set) d h v w z x1 x2 :=
  let u := dir v w in let o := offset v w z in
  (forall x, P (Seg v w) x \/ P (Seg w v) x -> not_between x1 x2 (dot u (vsub x v))) /\
  (forall a b c x, same_tri v w z a b c -> P (Tri a b c) x -> not_between x1 x2 (dot u (vsub x v)) \/
     clear_of h (vadd v (vadd (vscale x1 u) (vscale d o))) (vadd v (vadd (vscale x2 u) (vscale d o))) x).

(** C is legal if its circle is empty in the plane of its face. *)
Definition C_legal (P : point_set) v w z c p := forall t x, P t x -> incl (corners t) [v; w; z] -> 0 <= power c p x.

Section InFace.
Variables (K : complex) (r phi beta d h alpha : R) (P : point_set).
Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.
Hypothesis HP : forall t x, P t x -> has K t /\ placed r beta d t x.

Ltac numbers := destruct (numbers r phi beta d h alpha HS) as
  (Nr & Np & Nb & Nd & Nh & Nbr & Nd0 & Ndh & Nrh & Nsep & Nsep2 & Ncb & Nsp & Ncp & Ndm & Ndr).

(** Direction of an edge of the face at v, in polar form. *)
Lemma own_edge_direction v w z zx zy theta w' t : frame v w z (dir v w) (offset v w z) zx zy ->
  corner_angle v w z theta -> v <> w' -> (w' = w \/ w' = z) ->
  dot (arc_vec r v w z t) (dir v w') = r * cos t \/ dot (arc_vec r v w z t) (dir v w') = r * cos (theta - t).
Proof.
  intros F A _ [->| ->].
  - left. rewrite (arc_vec_eq _ _ _ _ _ _ _ F), dot_comm. unfold arc.
    apply (dot_frame _ _ (r * cos t) (r * sin t) (fr_u _ _ _ _ _ _ _ F) (fr_o _ _ _ _ _ _ _ F) (fr_uo _ _ _ _ _ _ _ F)).
  - right. rewrite (arc_vec_eq _ _ _ _ _ _ _ F), (arc_other _ _ theta r t).
    destruct (other_frame v w z _ _ zx zy theta F A) as (wx & wy & F2).
    destruct (frame_unique _ _ _ _ _ _ _ F2) as [-> _]. rewrite dot_comm.
    apply (dot_frame _ _ (r * cos (theta - t)) (r * sin (theta - t)) (fr_u _ _ _ _ _ _ _ F2) (fr_o _ _ _ _ _ _ _ F2) (fr_uo _ _ _ _ _ _ _ F2)).
Qed.

Lemma own_corner v w z w' (t : simplex) : v <> w' -> (forall c, In c [v; w'] <-> In c (corners t)) ->
  incl (corners t) [v; w; z] -> w' = w \/ w' = z.
Proof.
  intros N C I. assert (J : In w' [v; w; z]) by (apply I, C; simpl; tauto).
  destruct J as [J|[J|[J|[]]]]; [congruence|left; congruence|right; congruence].
Qed.

Lemma own_face v w z p q (t : simplex) : has K (Tri v p q) -> (forall c, In c [v; p; q] <-> In c (corners t)) ->
  incl (corners t) [v; w; z] -> same_tri v w z v p q.
Proof.
  intros G C I. destruct (tri_distinct K HK _ _ _ G) as (V1 & V2 & V3).
  assert (J1 : In p [v; w; z]) by (apply I, C; simpl; tauto).
  assert (J2 : In q [v; w; z]) by (apply I, C; simpl; tauto).
  destruct J1 as [J1|[J1|[J1|[]]]]; destruct J2 as [J2|[J2|[J2|[]]]]; subst; try congruence; unfold same_tri; tauto.
Qed.

Theorem T_in_face v w z c p t x : T_cell K r beta d v w z c p -> P t x -> incl (corners t) [v; w; z] -> 0 <= power c p x.
Proof.
  intros T Px N. destruct (HP t x Px) as [Ht Pl]. destruct T as [v w z H a]. numbers.
  rewrite power_translate. fold (T_power a (vsub x v)).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F).
  destruct (corner_angle_exists v w z (proper_tri K HK _ _ _ H)) as (theta & A).
  pose proof (corner_angle_ge K r phi alpha v w z theta HK HF H Np A) as TH. pose proof A as [Tr _].
  assert (EA : a = arc_vec r v w z beta) by (unfold a, arc_vec; rewrite Nd; reflexivity).
  assert (A2 : norm2 a = r * r).
  { rewrite EA, (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_norm2 v w z _ _ zx zy F). }
  destruct (classic (In v (corners t))) as [I|I].
  - destruct (carrier_at K r beta d t x v HK Ht Pl I) as [[_ ->]|[(w' & G & P' & C)|(p & q & G & P' & C)]].
    + replace (vsub v v) with vzero by (generalize v; veq). unfold T_power, power. lra.
    + destruct (edge_point K r phi beta d h alpha HK HS v w' x P' G) as (k & Hk & K0 & -> & U).
      apply T_vs_edge_points with (r := r) (beta := beta); try assumption. rewrite dot_comm, EA.
      pose proof (own_corner v w z w' t (proper_seg K HK _ _ G) C N) as W.
      destruct (own_edge_direction v w z zx zy theta w' beta F A (proper_seg K HK _ _ G) W) as [-> | ->]; [lra|].
      apply Rmult_le_compat_l; [lra|]. apply cos_decr_1; lra.
    + pose proof (placed_dist _ _ _ _ _ _ _ P') as B.
      eapply Rle_trans; [|apply T_vs_points_outside_ball with (r := r); [exact A2|rewrite norm2_of_dist; apply sq_le_mono; lra]].
      pose proof (dist2_nonneg (vsub x v) a). lra.
  - pose proof (far_from_corner K r phi beta d h alpha HK HF HS v t x (corner_has K HK _ _ _ H) Ht Pl I) as D.
    eapply Rle_trans; [|apply T_vs_points_outside_ball with (r := r); [exact A2|rewrite norm2_of_dist; apply sq_le_mono; lra]].
    pose proof (dist2_nonneg (vsub x v) a). lra.
Qed.

Theorem S_in_face v w z t1 t2 c p t x : S_cell K r beta h v w z t1 t2 c p -> S_legal P r h v w z t1 t2 ->
  P t x -> incl (corners t) [v; w; z] -> 0 <= power c p x.
Proof.
  intros T Lg Px N. destruct (HP t x Px) as [Ht Pl]. destruct T as [v w z theta t1 t2 H A H1 H2 H3 HC b]. numbers.
  unfold S_legal in Lg. set (a := (t2 - t1) / 2) in *. set (tm := (t1 + t2) / 2) in *.
  rewrite power_translate. fold (spoke_centre b r a). fold (spoke_power b r a (vsub x v)).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F). pose proof A as [Tr _].
  assert (Ar : 0 < a < PI / 2) by (unfold a; lra).
  destruct (margin_half_angle r phi beta d h (set_parameters _ _ _ _ _ _ HS) a Ar HC) as [Ab Ca].
  destruct (bisector r v w z zx zy tm F) as [B EB]. fold b in B, EB.
  destruct (classic (In v (corners t))) as [I|I].
  - destruct (carrier_at K r beta d t x v HK Ht Pl I) as [[_ ->]|[(w' & G & P' & C)|(p & q & G & P' & C)]].
    + replace (vsub v v) with vzero by (generalize v; veq). unfold spoke_power, power. lra.
    + destruct (edge_point K r phi beta d h alpha HK HS v w' x P' G) as (k & Hk & K0 & -> & U).
      apply Rlt_le, S_vs_own_edges with (beta := beta); try assumption.
      pose proof (own_corner v w z w' t (proper_seg K HK _ _ G) C N) as W.
      assert (D : dot b (dir v w') = cos tm \/ dot b (dir v w') = cos (theta - tm)).
      { destruct (own_edge_direction v w z zx zy theta w' tm F A (proper_seg K HK _ _ G) W) as [D|D];
          rewrite EB, dot_scale_l in D; [left|right]; apply Rmult_eq_reg_l with r; lra. }
      destruct D as [-> | ->]; apply cos_decr_1; unfold tm, a in *; lra.
    + pose proof (placed_dist _ _ _ _ _ _ _ P') as BX.
      assert (NX : r * r <= norm2 (vsub x v)) by (rewrite norm2_of_dist; apply sq_le_mono; lra).
      pose proof (own_face v w z p q t G C N) as SF.
      destruct t as [t0|t0 t3|a0 b0 c0].
      1: { exfalso. pose proof (proj1 (C p) ltac:(simpl; tauto)) as J. destruct J as [J|[]].
           pose proof (proj1 (C v) ltac:(simpl; tauto)) as J2. destruct J2 as [J2|[]].
           destruct (tri_distinct K HK _ _ _ G). congruence. }
      1: { exfalso. pose proof (proj1 (C p) ltac:(simpl; tauto)) as J. pose proof (proj1 (C v) ltac:(simpl; tauto)) as J2.
           pose proof (proj1 (C q) ltac:(simpl; tauto)) as J3. simpl in *. destruct (tri_distinct K HK _ _ _ G) as (V1 & V2 & V3).
           destruct J as [J|[J|[]]]; destruct J2 as [J2|[J2|[]]]; destruct J3 as [J3|[J3|[]]]; congruence. }
      assert (S0 : same_tri v w z a0 b0 c0).
      { destruct (tri_distinct K HK _ _ _ Ht) as (V1 & V2 & V3).
        pose proof (N a0 ltac:(simpl; tauto)) as J1. pose proof (N b0 ltac:(simpl; tauto)) as J2. pose proof (N c0 ltac:(simpl; tauto)) as J3.
        destruct J1 as [J1|[J1|[J1|[]]]]; destruct J2 as [J2|[J2|[J2|[]]]]; destruct J3 as [J3|[J3|[J3|[]]]];
          subst; try congruence; unfold same_tri; tauto. }
      destruct (Lg a0 b0 c0 x S0 Px) as [DO|CL].
      * apply S_vs_directions_outside; try assumption; lra.
      * destruct (Rlt_le_dec (spoke_power b r a (vsub x v)) 0) as [NEG|POS]; [exfalso|exact POS].
        (* coordinates along the bisector *)
        assert (Pv : placed r beta d (Tri v w z) x).
        { eapply placed_perm; [|exact P']. unfold same_tri in SF |- *.
          repeat destruct SF as [SF|SF]; destruct SF as (E1 & E2 & E3); subst; tauto. }
        destruct (placed_frame r beta d v w z _ _ _ _ x F Pv) as (X & Y & _ & E & _).
        set (u := dir v w) in *. set (o := offset v w z) in *.
        set (g := vadd (vscale (- sin tm) u) (vscale (cos tm) o)).
        assert (Eb : b = vadd (vscale (cos tm) u) (vscale (sin tm) o)).
        { unfold b, arc_vec. fold u o. rewrite !Rmult_1_l. reflexivity. }
        pose proof (sin2_cos2 tm) as SC. unfold Rsqr in SC.
        pose proof (fr_u _ _ _ _ _ _ _ F) as U. pose proof (fr_o _ _ _ _ _ _ _ F) as O. pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
        assert (OR : orthonormal2 b g).
        { split; [exact B|]. unfold g. destruct (dot_frame u o (- sin tm) (cos tm) U O UO) as (D1 & D2 & D3).
          split; [rewrite D3; lra|]. rewrite Eb, dot_add_l, !dot_scale_l. fold g. unfold g. rewrite D1, D2. ring. }
        assert (EX : vsub x v = vadd (vscale (X * cos tm + Y * sin tm) b) (vscale (Y * cos tm - X * sin tm) g)).
        { rewrite E, Eb. unfold g.
          transitivity (vadd (vscale (X * (sin tm * sin tm + cos tm * cos tm)) u) (vscale (Y * (sin tm * sin tm + cos tm * cos tm)) o)).
          - rewrite SC, !Rmult_1_r. reflexivity.
          - generalize u o. intros. apply vec_eq; unfold vadd, vscale; simpl; ring. }
        rewrite EX in NX, NEG.
        assert (A4 : 0 < a <= PI / 4) by lra.
        destruct (S_reach b g r a _ _ OR Nr A4 NX (Rlt_le _ _ NEG)) as (s & Hs & DS).
        specialize (CL s Hs).
        assert (EP : arc_vec r v w z t1 = spoke_start b g r a).
        { unfold arc_vec, spoke_start, in_face. fold u o. rewrite Eb. unfold g. rewrite cos_neg, sin_neg.
          replace t1 with (tm - a) by (unfold tm, a; field). rewrite cos_minus, sin_minus.
          generalize u o. intros. apply vec_eq; unfold vadd, vscale; simpl; ring. }
        assert (EQ : arc_vec r v w z t2 = spoke_end b g r a).
        { unfold arc_vec, spoke_end, in_face. fold u o. rewrite Eb. unfold g.
          replace t2 with (tm + a) by (unfold tm, a; field). rewrite cos_plus, sin_plus.
          generalize u o. intros. apply vec_eq; unfold vadd, vscale; simpl; ring. }
        rewrite EP, EQ in CL. rewrite <- EX in DS.
        assert (ED : dist2 x (along (vadd v (spoke_start b g r a)) (vadd v (spoke_end b g r a)) s)
                     = dist2 (vsub x v) (along (spoke_start b g r a) (spoke_end b g r a) s)).
        { generalize x v (spoke_start b g r a) (spoke_end b g r a). vring. }
        pose proof (dist_sqr x (along (vadd v (spoke_start b g r a)) (vadd v (spoke_end b g r a)) s)) as SQ.
        pose proof (margin_spoke_bulge r phi beta d h (set_parameters _ _ _ _ _ _ HS) a ltac:(lra) HC) as BU.
        assert (BU0 : 0 <= r / cos a - r * cos a).
        { assert (cos a <= 1) by apply COS_bound.
          assert (M0 : 0 < r / cos a) by (apply Rdiv_lt_0_compat; lra).
          assert (MM : r / cos a * cos a = r) by (field; lra). set (m := r / cos a) in *.
          replace (m - r * cos a) with (m * (1 - cos a * cos a)) by (rewrite <- MM; ring).
          apply Rmult_le_pos; [lra|]. assert (cos a * cos a <= 1 * 1) by (apply sq_le_mono; lra). lra. }
        rewrite ED in SQ.
        assert ((h / 2) * (h / 2) < 74 / 1000 * h * (74 / 1000 * h)); [|nra].
        eapply Rlt_le_trans; [apply sq_lt_mono; [lra|exact CL]|]. rewrite SQ.
        eapply Rle_trans; [exact DS|]. apply sq_le_mono; lra.
  - pose proof (far_from_corner K r phi beta d h alpha HK HF HS v t x (corner_has K HK _ _ _ H) Ht Pl I) as D.
    apply Rlt_le, S_vs_far; try assumption; try lra.
    change (norm (vsub x v)) with (dist x v). rewrite dist_sym. nra.
Qed.
End InFace.

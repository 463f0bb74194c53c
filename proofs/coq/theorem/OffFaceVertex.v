(** T and S cells: no point carried by a simplex off their face is in the closed
    diametral ball (L9, L10, L11 for points off the plane). *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins EdgeFaceAngle VertexCells.
From Confidel.theorem Require Import Complex Placement FaceGeometry Separation.
Import ListNotations.
Open Scope R_scope.

Lemma placed_dist r beta d v p q x : placed r beta d (Tri v p q) x -> r <= dist v x.
Proof. intros [_ P]. apply (P v p q). unfold same_tri. tauto. Qed.

Section OffFaceVertex.
Variables (K : complex) (r phi beta d h alpha : R).
Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.

Ltac numbers := destruct (numbers r phi beta d h alpha HS) as
  (Nr & Np & Nb & Nd & Nh & Nbr & Nd0 & Ndh & Nrh & Nsep & Nsep2 & Ncb & Nsp & Ncp & Ndm & Ndr).

Lemma corner_has v w z : has K (Tri v w z) -> has K (Pt v).
Proof. intros H. apply (closed_pt K HK v w), (closed_seg K HK v w z), H. Qed.

Lemma norm2_of_dist v x : norm2 (vsub x v) = dist v x * dist v x.
Proof. rewrite dist_sqr, dist2_sym. reflexivity. Qed.

Theorem T_off_face v w z c p t x : T_cell K r beta d v w z c p ->
  has K t -> placed r beta d t x -> ~ incl (corners t) [v; w; z] -> 0 < power c p x.
Proof.
  intros T Ht P N. destruct T as [v w z H a]. numbers. rewrite power_translate. fold (T_power a (vsub x v)).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F).
  destruct (corner_angle_exists v w z (proper_tri K HK _ _ _ H)) as (theta & A).
  pose proof (corner_angle_ge K r phi alpha v w z theta HK HF H Np A) as TH. pose proof A as [Tr _].
  assert (EA : a = arc_vec r v w z beta) by (unfold a, arc_vec; rewrite Nd; reflexivity).
  assert (A2 : norm2 a = r * r).
  { rewrite EA, (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_norm2 v w z _ _ zx zy F). }
  destruct (classic (In v (corners t))) as [I|I].
  - destruct (carrier_at K r beta d t x v HK Ht P I) as [[-> _]|[(w' & G & P' & C)|(p & q & G & P' & C)]].
    + exfalso. apply N. intros y [<-|[]]. simpl. tauto.
    + assert (N' : ~ incl [v; w'] [v; w; z]) by (intros J; apply N; intros y Hy; apply J, C, Hy).
      destruct (edge_point K r phi beta d h alpha HK HS v w' x P' G) as (k & Hk & K0 & -> & U).
      apply T_vs_edge_points_strict with (r := r) (beta := beta); try assumption.
      * assert (SA : sector v (Tri v w z) a).
        { rewrite EA, (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_in_sector v w z _ _ zx zy theta); try assumption; lra. }
        pose proof (edge_angle K r phi alpha HK HF v w z w' a H G N' SA) as L.
        assert (NA : norm a = r) by (unfold norm; rewrite A2; apply sqrt_square; lra).
        rewrite NA in L. nra.
      * left. assert (SA : sector v (Tri v w z) a).
        { rewrite EA, (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_in_sector v w z _ _ zx zy theta); try assumption; lra. }
        pose proof (edge_angle K r phi alpha HK HF v w z w' a H G N' SA) as L.
        assert (NA : norm a = r) by (unfold norm; rewrite A2; apply sqrt_square; lra).
        rewrite NA in L. nra.
    + assert (N' : ~ incl [v; p; q] [v; w; z]) by (intros J; apply N; intros y Hy; apply J, C, Hy).
      assert (B : r <= dist v x) by (apply (placed_dist _ _ _ _ _ _ _ P')).
      pose proof (arc_vs_face K r phi beta d h alpha HK HF HS v w z theta beta p q x H A ltac:(lra) G N' P') as D.
      rewrite <- EA in D.
      apply Rlt_le_trans with (dist2 (vsub x v) a / 2); [nra|].
      apply T_vs_points_outside_ball with (r := r); [exact A2|]. rewrite norm2_of_dist. apply sq_le_mono; lra.
  - pose proof (far_from_corner K r phi beta d h alpha HK HF HS v t x (corner_has _ _ _ H) Ht P I) as D.
    assert (NX : (3 * r) * (3 * r) <= norm2 (vsub x v)) by (rewrite norm2_of_dist; apply sq_le_mono; lra).
    apply T_vs_points_outside_ball_strict with (r := r); [exact A2|nra|].
    intros E. rewrite E, A2 in NX. nra.
Qed.

(** The unit bisector of a spoke. *)
Lemma bisector v w z zx zy t : frame v w z (dir v w) (offset v w z) zx zy ->
  norm2 (arc_vec 1 v w z t) = 1 /\ arc_vec r v w z t = vscale r (arc_vec 1 v w z t).
Proof.
  intros F. rewrite !(arc_vec_eq _ _ _ _ _ _ _ F). split.
  - rewrite (arc_norm2 v w z _ _ zx zy F). ring.
  - unfold arc. generalize (dir v w) (offset v w z). intros. apply vec_eq; unfold vadd, vscale; simpl; ring.
Qed.

Theorem S_off_face v w z t1 t2 c p t x : S_cell K r beta h v w z t1 t2 c p ->
  has K t -> placed r beta d t x -> ~ incl (corners t) [v; w; z] -> 0 < power c p x.
Proof.
  intros T Ht P N. destruct T as [v w z theta t1 t2 H A H1 H2 H3 HC b]. numbers.
  set (a := (t2 - t1) / 2) in *. rewrite power_translate. fold (spoke_centre b r a). fold (spoke_power b r a (vsub x v)).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F). pose proof A as [Tr _].
  assert (Ar : 0 < a < PI / 2) by (unfold a; lra).
  destruct (margin_half_angle r phi beta d h (set_parameters _ _ _ _ _ _ HS) a Ar HC) as [Ab Ca].
  destruct (bisector v w z zx zy ((t1 + t2) / 2) F) as [B EB]. fold b in B, EB.
  assert (SB : sector v (Tri v w z) b).
  { unfold b. rewrite (arc_vec_eq _ _ _ _ _ _ _ F). apply (arc_in_sector v w z _ _ zx zy theta); try assumption; lra. }
  destruct (classic (In v (corners t))) as [I|I].
  - destruct (carrier_at K r beta d t x v HK Ht P I) as [[-> _]|[(w' & G & P' & C)|(p & q & G & P' & C)]].
    + exfalso. apply N. intros y [<-|[]]. simpl. tauto.
    + assert (N' : ~ incl [v; w'] [v; w; z]) by (intros J; apply N; intros y Hy; apply J, C, Hy).
      destruct (edge_point K r phi beta d h alpha HK HS v w' x P' G) as (k & Hk & K0 & -> & U).
      pose proof (edge_angle K r phi alpha HK HF v w z w' b H G N' SB) as L.
      assert (NB : norm b = 1) by (unfold norm; rewrite B; apply sqrt_1). rewrite NB, dot_comm in L.
      apply edge_face_clear_strict with (beta := beta) (phi := phi); try assumption; try lra.
      (* a < beta = phi/3, so a + beta < phi *)
      pose proof PI_RGT_0. assert (cos phi < cos (beta + a)) by (apply cos_decreasing_1; lra).
      assert (0 < sin beta) by (apply sin_gt_0; lra). assert (0 < sin a) by (apply sin_gt_0; lra).
      rewrite cos_plus in *. nra.
    + assert (N' : ~ incl [v; p; q] [v; w; z]) by (intros J; apply N; intros y Hy; apply J, C, Hy).
      assert (BX : r <= dist v x) by (apply (placed_dist _ _ _ _ _ _ _ P')).
      pose proof (arc_vs_face K r phi beta d h alpha HK HF HS v w z theta ((t1 + t2) / 2) p q x H A ltac:(lra) G N' P') as D.
      rewrite EB in D.
      apply S_vs_far_from_arc; try assumption; try lra.
      * rewrite norm2_of_dist. apply sq_le_mono; lra.
      * eapply Rlt_le_trans; [|exact D].
        pose proof (arc_middle_reach r a ltac:(lra)) as M.
        assert (0 < sin a) by (apply sin_gt_0; lra).
        assert ((2 * r * sin a) * (2 * r * sin a) <= (3 / 2 * h) * (3 / 2 * h)) by (apply sq_le_mono; nra). nra.
  - pose proof (far_from_corner K r phi beta d h alpha HK HF HS v t x (corner_has _ _ _ H) Ht P I) as D.
    apply S_vs_far; try assumption; try lra.
    change (norm (vsub x v)) with (dist x v). rewrite dist_sym. nra.
Qed.
End OffFaceVertex.

(** R and C cells: no point carried by a simplex off their face is in the closed
    diametral ball (L12, L13, L16 for points off the plane). *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins DihedralGap EdgeCells FaceCells.
From Confidel.theorem Require Import Complex Placement FaceGeometry Separation OffFaceVertex.
Import ListNotations.
Open Scope R_scope.

Section OffFaceEdge.
Variables (K : complex) (r phi beta d h alpha : R).
Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.

Ltac numbers := destruct (numbers r phi beta d h alpha HS) as
  (Nr & Np & Nb & Nd & Nh & Nbr & Nd0 & Ndh & Nrh & Nsep & Nsep2 & Ncb & Nsp & Ncp & Ndm & Ndr).

(** ** R *)

(** Points beside the ends of the edge, wherever they are. *)
Lemma R_beside u o x1 x2 k y m : norm2 u = 1 -> norm2 o = 1 -> dot u o = 0 -> dot u y = 0 ->
  0 < d -> d <= m -> m * m <= (k - x1) * (k - x2) -> 0 < R_power u o d x1 x2 (vadd (vscale k u) y).
Proof.
  intros U O UO Y Hd Hm H. rewrite R_power_eq by assumption. rewrite dot_sub_r, dot_scale_r.
  pose proof (cauchy_schwarz2 y o) as CS. rewrite O in CS. change (dot y y) with (norm2 y).
  set (t := dot y o) in *. set (n := norm2 y) in *.
  pose proof (Rle_0_sqr (t - d / 2)) as S. unfold Rsqr in S. nra.
Qed.

Lemma split_along u y : norm2 u = 1 -> y = vadd (vscale (dot y u) u) (across u y).
Proof. intros U. unfold across. generalize (dot y u). intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. Qed.

(** The same cell read from the other end of its edge: same centre, same radius. *)
Lemma R_cell_swap v w z x1 x2 c p : R_cell K r beta d h v w z x1 x2 c p ->
  exists p', R_cell K r beta d h w v z (dist v w - x2) (dist v w - x1) c p' /\
    forall x, power c p' x = power c p x.
Proof.
  intros R. destruct R as [v w z x1 x2 H H1 H2 H3 H4 u].
  assert (H' : has K (Tri w v z)) by (apply has_tri_swap, H).
  destruct (tri_distinct K HK _ _ _ H) as (V1 & V2 & V3).
  pose proof (dir_scale v w V1) as E. pose proof (dir_norm2 v w V1) as U.
  pose proof (offset_swap K v w z HK H) as EO. pose proof (dir_opposite v w) as ED.
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F). pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
  set (o := offset v w z) in *. fold u in E, U, ED, UO. set (L := dist v w) in *.
  assert (W : w = vadd v (vscale L u)).
  { rewrite <- E. generalize v w. intros. apply vec_eq; unfold vadd, vsub; simpl; ring. }
  set (c := vadd v (vadd (vscale ((x1 + x2) / 2) u) (vscale (d / 2) o))).
  assert (EC : c = vadd w (vadd (vscale ((L - x2 + (L - x1)) / 2) (dir w v)) (vscale (d / 2) (offset w v z)))).
  { rewrite EO, ED, W. unfold c. generalize v u o. intros. apply vec_eq; unfold vadd, vscale; simpl; field. }
  exists (vadd w (vscale (L - x2) (dir w v))). split.
  - rewrite EC. unfold L. rewrite <- (dist_sym w v). apply R_intro; try assumption; rewrite ?(dist_sym w v); fold L; lra.
  - intros x. rewrite ED. unfold power. f_equal.
    rewrite W. unfold c.
    replace (dist2 (vadd v (vadd (vscale ((x1 + x2) / 2) u) (vscale (d / 2) o))) (vadd v (vscale x1 u)))
      with ((x2 - x1) / 2 * ((x2 - x1) / 2) * norm2 u + d / 2 * (d / 2) * norm2 o + (x2 - x1) / 2 * d * dot u o).
    + replace (dist2 (vadd v (vadd (vscale ((x1 + x2) / 2) u) (vscale (d / 2) o)))
        (vadd (vadd v (vscale L u)) (vscale (L - x2) (vscale (-1) u))))
        with ((x2 - x1) / 2 * ((x2 - x1) / 2) * norm2 u + d / 2 * (d / 2) * norm2 o - (x2 - x1) / 2 * d * dot u o).
      * rewrite UO. ring.
      * generalize v u o. intros [? ? ?] [? ? ?] [? ? ?]. unfold dist2, norm2, dot, vadd, vsub, vscale; simpl. field.
    + generalize v u o. intros [? ? ?] [? ? ?] [? ? ?]. unfold dist2, norm2, dot, vadd, vsub, vscale; simpl. field.
Qed.

(** Carriers that share exactly the end v with the edge, in its face or not. *)
Lemma R_vs_end v w z x1 x2 c p t x : R_cell K r beta d h v w z x1 x2 c p ->
  has K t -> placed r beta d t x -> In v (corners t) -> ~ In w (corners t) -> 0 < power c p x.
Proof.
  intros R Ht P I J. destruct R as [v w z x1 x2 H H1 H2 H3 H4 u]. numbers.
  rewrite power_translate. fold (R_centre u (offset v w z) d x1 x2).
  fold (R_power u (offset v w z) d x1 x2 (vsub x v)).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F).
  pose proof (fr_u _ _ _ _ _ _ _ F) as U. pose proof (fr_o _ _ _ _ _ _ _ F) as O. pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
  fold u in U, UO. set (o := offset v w z) in *.
  assert (HE : has K (Seg v w)) by (apply (closed_seg K HK v w z), H).
  assert (M : forall s, In v (corners s) -> (forall y, In y (corners s) -> In y (corners t)) -> meet_only_at v (Seg v w) s).
  { intros s Is Ss. split; [simpl; tauto|]. split; [exact Is|].
    intros y [<-|[<-|[]]] Y; [reflexivity|]. exfalso. apply J, Ss, Y. }
  assert (ANG : forall s k y, has K s -> In v (corners s) -> (forall y, In y (corners s) -> In y (corners t)) ->
    sector v s (vscale k y) -> norm2 y = 1 -> r * cos beta <= k ->
    0 < R_power u o d x1 x2 (vscale k y)).
  { intros s k y Hs Is Ss SY Y1 Hk.
    pose proof (feature_link K r phi alpha HF v _ _ (vscale 1 u) (vscale k y) HE Hs (M s Is Ss)
      (dir_in_sector K HK v w 1 HE ltac:(lra)) SY) as L.
    assert (K0 : 0 < k) by nra.
    assert (NU : norm (vscale 1 u) = 1).
    { rewrite norm_scale. unfold norm. rewrite U, sqrt_1, Rabs_R1. ring. }
    assert (NY : norm (vscale k y) = k).
    { rewrite norm_scale. unfold norm. rewrite Y1, sqrt_1, Rabs_pos_eq; lra. }
    rewrite NU, NY, dot_scale_l, dot_scale_r in L.
    apply R_vs_directions with (m := r * cos beta) (phi := phi) (h := h); try assumption; try lra. nra. }
  destruct (carrier_at K r beta d t x v HK Ht P I) as [[-> ->]|[(w' & G & P' & C)|(a & b & G & P' & C)]].
  - replace (vsub v v) with (vadd (vscale 0 u) vzero) by (generalize v u; veq).
    apply R_beside with (m := r * cos beta); try assumption; try lra; [apply dot_zero_r|].
    replace ((0 - x1) * (0 - x2)) with (x1 * x2) by ring. apply Rmult_le_compat; nra.
  - destruct (edge_point K r phi beta d h alpha HK HS v w' x P' G) as (k & Hk & K0 & E & U'). rewrite E.
    apply (ANG (Seg v w')); try assumption; [simpl; tauto|intros y; apply C|].
    apply (dir_in_sector K HK); [exact G|lra].
  - pose proof (placed_dist _ _ _ _ _ _ _ P') as B.
    assert (N0 : vsub x v <> vzero).
    { intros Z. assert (norm2 (vsub x v) = 0) by (rewrite Z; vring). rewrite norm2_of_dist in H0. nra. }
    rewrite (unit_scale _ N0).
    apply (ANG (Tri v a b)); try assumption; [simpl; tauto|intros y; apply C| |apply unit_norm2, N0|].
    + rewrite <- (unit_scale _ N0). apply in_simplex_sector. apply P'.
    + change (norm (vsub x v)) with (dist x v). rewrite dist_sym. nra.
Qed.

(** Carriers that share no corner with the edge. *)
Lemma R_vs_disjoint v w z x1 x2 c p t x : R_cell K r beta d h v w z x1 x2 c p ->
  has K t -> placed r beta d t x -> ~ In v (corners t) -> ~ In w (corners t) -> 0 < power c p x.
Proof.
  intros R Ht P I J. destruct R as [v w z x1 x2 H H1 H2 H3 H4 u]. numbers.
  rewrite power_translate. fold (R_centre u (offset v w z) d x1 x2).
  fold (R_power u (offset v w z) d x1 x2 (vsub x v)).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F).
  pose proof (fr_u _ _ _ _ _ _ _ F) as U. pose proof (fr_o _ _ _ _ _ _ _ F) as O. pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
  pose proof (fr_w _ _ _ _ _ _ _ F) as W. pose proof (fr_w0 _ _ _ _ _ _ _ F) as L0.
  fold u in U, UO, W. set (o := offset v w z) in *.
  assert (HE : has K (Seg v w)) by (apply (closed_seg K HK v w z), H).
  set (y := vsub x v). rewrite (split_along u y U). set (k := dot y u). set (q := across u y).
  assert (Q : dot u q = 0) by (apply across_parts; exact U).
  assert (mp : 0 < r * cos beta) by nra.
  destruct (Rle_lt_dec k 0) as [K0|K0]; [|destruct (Rle_lt_dec (dist v w) k) as [K1|K1]].
  - apply R_beside with (m := r * cos beta); try assumption; try lra.
    replace ((k - x1) * (k - x2)) with ((x1 - k) * (x2 - k)) by ring. apply Rmult_le_compat; lra.
  - apply R_beside with (m := r * cos beta); try assumption; try lra. apply Rmult_le_compat; lra.
  - apply R_vs_far with (h := h); try assumption; try lra.
    assert (DD : 3 * r <= dist (vadd v (vscale k u)) x).
    { apply (feature_distance K r phi alpha HF (Seg v w) t); try assumption.
      - intros s [<-|[<-|[]]]; assumption.
      - exists (k / dist v w). assert (E : k / dist v w * dist v w = k) by (field; lra). split.
        + set (g := k / dist v w) in *. nra.
        + unfold along. rewrite W. set (g := k / dist v w) in *. rewrite <- E.
          generalize v u (dist v w). intros. apply vec_eq; unfold vadd, vscale; simpl; ring.
      - apply (carrier_contains K r phi beta d h alpha); assumption. }
    assert (EQ : norm2 q = dist2 (vadd v (vscale k u)) x).
    { rewrite dist2_sym. unfold dist2. f_equal. unfold q, across. fold k. unfold y.
      generalize x v u. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring. }
    rewrite EQ, <- dist_sqr. apply sq_le_mono; lra.
Qed.

(** Carriers with both ends of the edge: another face at the same edge. *)
Lemma R_vs_same_edge v w z x1 x2 c p z' x : R_cell K r beta d h v w z x1 x2 c p ->
  has K (Tri v w z') -> z' <> z -> placed r beta d (Tri v w z') x -> 0 < power c p x.
Proof.
  intros R G N P. destruct R as [v w z x1 x2 H H1 H2 H3 H4 u]. numbers.
  rewrite power_translate. fold (R_centre u (offset v w z) d x1 x2).
  fold (R_power u (offset v w z) d x1 x2 (vsub x v)).
  destruct (frame_of K HK _ _ _ H) as (zx & zy & F). destruct (frame_of K HK _ _ _ G) as (zx' & zy' & F').
  destruct (placed_frame r beta d v w z' _ _ _ _ x F' P) as (X & Y & D & E & _). rewrite E.
  destruct HS as [_ A G2].
  apply R_vs_other_face with (a := alpha) (h := h); try assumption; try lra;
    [apply (fr_u _ _ _ _ _ _ _ F)|apply (fr_o _ _ _ _ _ _ _ F)|apply (fr_o _ _ _ _ _ _ _ F')
    |apply (fr_uo _ _ _ _ _ _ _ F)|apply (fr_uo _ _ _ _ _ _ _ F')|].
  apply (feature_dihedral K r phi alpha HF); [exact H|exact G|congruence].
Qed.

Theorem R_off_face v w z x1 x2 c p t x : R_cell K r beta d h v w z x1 x2 c p ->
  has K t -> placed r beta d t x -> ~ incl (corners t) [v; w; z] -> 0 < power c p x.
Proof.
  intros R Ht P N.
  destruct (classic (In v (corners t))) as [I|I]; destruct (classic (In w (corners t))) as [J|J].
  - assert (H : has K (Tri v w z)) by (destruct R; assumption).
    destruct (tri_distinct K HK _ _ _ H) as (V1 & V2 & V3).
    destruct (carrier_at K r beta d t x v HK Ht P I) as [[-> _]|[(w' & G & P' & C)|(a & b & G & P' & C)]].
    + exfalso. apply N. intros y [<-|[]]. simpl. tauto.
    + exfalso. apply C in J. destruct J as [J|[J|[]]]; [congruence|subst w'].
      apply N. intros y Hy. apply C in Hy. destruct Hy as [<-|[<-|[]]]; simpl; tauto.
    + apply C in J. destruct J as [J|[J|[J|[]]]]; [congruence|subst a|subst b].
      * apply (R_vs_same_edge v w z x1 x2 c p b x R G); [|exact P'].
        intros ->. apply N. intros y Hy. apply C in Hy. exact Hy.
      * assert (S : same_tri v a w v w a) by (unfold same_tri; tauto).
        apply (R_vs_same_edge v w z x1 x2 c p a x R (same_tri_has K _ _ _ _ _ _ S G)); [|apply (placed_perm _ _ _ _ _ _ _ _ _ _ S P')].
        intros ->. apply N. intros y Hy. apply C in Hy. destruct Hy as [<-|[<-|[<-|[]]]]; simpl; tauto.
  - apply (R_vs_end v w z x1 x2 c p t); assumption.
  - destruct (R_cell_swap v w z x1 x2 c p R) as (p' & R' & E). rewrite <- E.
    eapply R_vs_end; [exact R'|exact Ht|exact P|exact J|exact I].
  - apply (R_vs_disjoint v w z x1 x2 c p t); assumption.
Qed.

(** ** C *)

(** Through a common corner v. *)
Lemma C_at_corner v w z c p t x : has K (Tri v w z) -> placed r beta d (Tri v w z) p ->
  (forall v' w' z', same_tri v w z v' w' z' -> plane_of v' w' z' c) -> dist c p <= h ->
  has K t -> placed r beta d t x -> ~ incl (corners t) [v; w; z] -> In v (corners t) -> 0 < power c p x.
Proof.
  intros H PP PL R Ht P N I. numbers.
  assert (BP : r <= dist v p) by (apply (placed_dist _ _ _ _ _ _ _ PP)).
  assert (NP : (r * cos beta) * (r * cos beta) <= norm2 (vsub p v)).
  { rewrite norm2_of_dist. apply sq_le_mono; nra. }
  assert (FAR : forall s, has K s -> meet_only_at v (Tri v w z) s -> in_simplex s x -> 0 < power c p x).
  { intros s Hs M IS.
    assert (T : power c p x = power (vsub c v) (vsub p v) (vsub x v)) by vring.
    rewrite T. pose proof PI_RGT_0. assert (K0 : 0 <= r * cos beta) by nra.
    assert (P2 : 0 <= phi <= PI / 2) by lra. assert (SP : 2 * h < r * cos beta * sin phi) by lra.
    assert (DC : dist (vsub c v) (vsub p v) <= h).
    { replace (dist (vsub c v) (vsub p v)) with (dist c p); [exact R|].
      unfold dist. f_equal. generalize c p v. veq. }
    apply C_vs_vertex with (h := h) (k := r * cos beta) (phi := phi); try assumption.
    apply (feature_link K r phi alpha HF v _ _ _ _ H Hs M); apply in_simplex_sector; [apply PP|exact IS]. }
  destruct (carrier_at K r beta d t x v HK Ht P I) as [[-> _]|[(w' & G & P' & C)|(a & b & G & P' & C)]].
  - exfalso. apply N. intros y [<-|[]]. simpl. tauto.
  - assert (N' : ~ incl [v; w'] [v; w; z]) by (intros J; apply N; intros y Hy; apply J, C, Hy).
    apply (FAR (Seg v w') G); [apply (edge_and_face_at K HK); assumption|].
    apply (carrier_contains K r phi beta d h alpha); assumption.
  - assert (N' : ~ incl [v; a; b] [v; w; z]) by (intros J; apply N; intros y Hy; apply J, C, Hy).
    destruct (two_faces_at K HK _ _ _ _ _ H G N') as [M|(e & g & z' & S1 & S2 & NE)].
    + apply (FAR (Tri v a b) G M). apply P'.
    + pose proof (same_tri_has K _ _ _ _ _ _ S1 H) as H'. pose proof (same_tri_has K _ _ _ _ _ _ S2 G) as G'.
      pose proof (placed_perm _ _ _ _ _ _ _ _ _ _ S2 P') as Px. pose proof (placed_perm _ _ _ _ _ _ _ _ _ _ S1 PP) as Pp.
      destruct (frame_of K HK _ _ _ H') as (zx & zy & F). destruct (frame_of K HK _ _ _ G') as (zx' & zy' & F').
      destruct (placed_frame r beta d _ _ _ _ _ _ _ x F' Px) as (X & Y & D & E & _).
      destruct (placed_frame r beta d _ _ _ _ _ _ _ p F Pp) as (X' & Y' & D' & E' & _).
      destruct (PL v e g S1) as (Xc & Yc & Ec).
      assert (T : power c p x = power (vsub c v) (vsub p v) (vsub x v)) by vring.
      rewrite T, E, E'. destruct HS as [_ A G2].
      apply C_vs_other_face with (kc := Xc) (qc := Yc) (d := d) (a := alpha) (h := h); try assumption; try lra;
        [apply (fr_u _ _ _ _ _ _ _ F)|apply (fr_o _ _ _ _ _ _ _ F)|apply (fr_o _ _ _ _ _ _ _ F')
        |apply (fr_uo _ _ _ _ _ _ _ F)|apply (fr_uo _ _ _ _ _ _ _ F')| |].
      * apply (feature_dihedral K r phi alpha HF); [exact H'|exact G'|congruence].
      * rewrite <- E'. replace (dist (vsub c v) (vsub p v)) with (dist c p); [exact R|].
        unfold dist. f_equal. generalize c p v. veq.
Qed.

Theorem C_off_face v w z c p t x : C_cell K r beta d h v w z c p ->
  has K t -> placed r beta d t x -> ~ incl (corners t) [v; w; z] -> 0 < power c p x.
Proof.
  intros CC Ht P N. destruct CC as [v w z c p H PP PL R]. numbers.
  destruct (classic (exists a, In a [v; w; z] /\ In a (corners t))) as [(a & A1 & A2)|D].
  - assert (exists b g, same_tri v w z a b g) as (b & g & S).
    { destruct A1 as [<-|[<-|[<-|[]]]]; [exists w, z|exists z, v|exists v, w]; unfold same_tri; tauto. }
    apply (C_at_corner a b g c p t x); try assumption.
    + apply (same_tri_has K _ _ _ _ _ _ S H).
    + apply (placed_perm _ _ _ _ _ _ _ _ _ _ S PP).
    + intros v' w' z' S'. apply PL. apply (same_tri_trans _ _ _ _ _ _ _ _ _ S S').
    + intros I. apply N. intros y Hy. apply (same_tri_in _ _ _ _ _ _ y S). apply I, Hy.
  - apply C_vs_far with (h := h); try assumption.
    assert (3 * r <= dist p x); [|lra].
    apply (feature_distance K r phi alpha HF (Tri v w z) t); try assumption.
    + intros y Y Y'. apply D. exists y. split; assumption.
    + apply PP.
    + apply (carrier_contains K r phi beta d h alpha); assumption.
Qed.
End OffFaceEdge.

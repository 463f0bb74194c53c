(** R cells against the points of their own face. *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins EdgeCells.
From Confidel.theorem Require Import Complex Placement FaceGeometry Separation OffFaceVertex OffFaceEdge InFace.
Import ListNotations.
Open Scope R_scope.

Section InFaceEdge.
Variables (K : complex) (r phi beta d h alpha : R) (P : point_set).
Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.
Hypothesis HP : forall t x, P t x -> has K t /\ placed r beta d t x.

Ltac numbers := destruct (numbers r phi beta d h alpha HS) as
  (Nr & Np & Nb & Nd & Nh & Nbr & Nd0 & Ndh & Nrh & Nsep & Nsep2 & Ncb & Nsp & Ncp & Ndm & Ndr).

(** Clear of the side q1 q2 and between its ends means far from the edge. *)
Lemma clear_between v u o x1 x2 x X Y : norm2 u = 1 -> norm2 o = 1 -> dot u o = 0 ->
  vsub x v = vadd (vscale X u) (vscale Y o) -> x1 < X < x2 -> 0 < h -> d <= Y ->
  clear_of h (vadd v (vadd (vscale x1 u) (vscale d o))) (vadd v (vadd (vscale x2 u) (vscale d o))) x ->
  d + h / 2 <= Y.
Proof.
  intros U O UO E B Hh D C.
  set (t := (X - x1) / (x2 - x1)). assert (T : t * (x2 - x1) = X - x1) by (unfold t; field; lra).
  assert (T01 : 0 <= t <= 1) by (split; nra).
  specialize (C t T01).
  assert (ED : dist2 x (along (vadd v (vadd (vscale x1 u) (vscale d o))) (vadd v (vadd (vscale x2 u) (vscale d o))) t)
    = (Y - d) * (Y - d)).
  { transitivity (norm2 (vscale (Y - d) o)).
    - unfold dist2. f_equal. replace x with (vadd v (vsub x v)) by (generalize x v; veq). rewrite E.
      assert (EX : X = x1 + t * (x2 - x1)) by lra. rewrite EX.
      generalize v u o t. intros. apply vec_eq; unfold along, vadd, vsub, vscale; simpl; ring.
    - unfold norm2 in *. rewrite dot_scale_l, dot_scale_r, O. ring. }
  pose proof (dist_sqr x (along (vadd v (vadd (vscale x1 u) (vscale d o))) (vadd v (vadd (vscale x2 u) (vscale d o))) t)) as SQ.
  rewrite ED in SQ. set (q := dist x _) in *. nra.
Qed.

Theorem R_in_face v w z x1 x2 c p t x : R_cell K r beta d h v w z x1 x2 c p -> R_legal P d h v w z x1 x2 ->
  P t x -> incl (corners t) [v; w; z] -> 0 <= power c p x.
Proof.
  intros RC Lg Px N. destruct (HP t x Px) as [Ht Pl].
  destruct (classic (In v (corners t))) as [I|I]; destruct (classic (In w (corners t))) as [J|J].
  - destruct RC as [v w z x1 x2 H H1 H2 H3 H4 u]. numbers. destruct Lg as [L1 L2].
    destruct (tri_distinct K HK _ _ _ H) as (V1 & V2 & V3).
    rewrite power_translate. fold (R_centre u (offset v w z) d x1 x2).
    fold (R_power u (offset v w z) d x1 x2 (vsub x v)).
    destruct (frame_of K HK _ _ _ H) as (zx & zy & F).
    pose proof (fr_u _ _ _ _ _ _ _ F) as U. pose proof (fr_o _ _ _ _ _ _ _ F) as O. pose proof (fr_uo _ _ _ _ _ _ _ F) as UO.
    fold u in U, UO, L1, L2. set (o := offset v w z) in *.
    destruct t as [a|a b|a b c].
    + exfalso. destruct I as [->|[]]. destruct J as [J|[]]. congruence.
    + (* a row point *)
      assert (NB : not_between x1 x2 (dot u (vsub x v))).
      { apply L1. destruct I as [I|[I|[]]]; destruct J as [J|[J|[]]]; try congruence; subst a b; tauto. }
      assert (Pv : placed r beta d (Seg v w) x).
      { destruct I as [I|[I|[]]]; destruct J as [J|[J|[]]]; try congruence; subst a b;
          first [exact Pl|apply placed_seg_sym; [congruence|exact Pl]]. }
      destruct Pv as (k & Hk & ->). fold u.
      assert (E : vsub (vadd v (vscale k u)) v = vadd (vscale k u) vzero) by (generalize v u; veq).
      fold u in NB. rewrite E in NB |- *. rewrite dot_add_r, dot_zero_r, dot_scale_r in NB.
      unfold norm2 in U. rewrite U in NB.
      apply R_vs_aligned; try assumption; try lra.
      * apply dot_zero_r.
      * unfold not_between in *. lra.
      * rewrite dot_zero_l. lra.
    + (* a point of the face *)
      assert (S0 : same_tri v w z a b c).
      { destruct (tri_distinct K HK _ _ _ Ht) as (W1 & W2 & W3).
        pose proof (N a ltac:(simpl; tauto)) as J1. pose proof (N b ltac:(simpl; tauto)) as J2. pose proof (N c ltac:(simpl; tauto)) as J3.
        destruct J1 as [J1|[J1|[J1|[]]]]; destruct J2 as [J2|[J2|[J2|[]]]]; destruct J3 as [J3|[J3|[J3|[]]]];
          subst; try congruence; unfold same_tri; tauto. }
      assert (Pv : placed r beta d (Tri v w z) x).
      { eapply placed_perm; [|exact Pl]. unfold same_tri in S0 |- *.
        repeat destruct S0 as [S0|S0]; destruct S0 as (E1 & E2 & E3); subst; tauto. }
      destruct (placed_frame r beta d v w z _ _ _ _ x F Pv) as (X & Y & D & E & _). fold u in E.
      destruct (dot_frame u o X Y U O UO) as (DX & _ & _).
      assert (AL : not_between x1 x2 X -> 0 <= R_power u o d x1 x2 (vsub x v)).
      { intros NB. rewrite E. apply R_vs_aligned; try assumption; try lra.
        - rewrite dot_scale_r, UO. ring.
        - apply (offset_passes o o d Y); assumption. }
      destruct (classic (not_between x1 x2 X)) as [NB|NB]; [apply AL, NB|].
      destruct (L2 a b c x S0 Px) as [NB'|CL].
      * exfalso. apply NB. rewrite E, DX in NB'. exact NB'.
      * assert (B : x1 < X < x2).
        { unfold not_between in NB. split; apply Rnot_le_lt; intros Z; apply NB; [left|right]; exact Z. }
        pose proof (clear_between v u o x1 x2 x X Y U O UO E B Nh D CL) as DY.
        rewrite E. apply Rlt_le, R_vs_own_face with (h := h); try assumption; lra.
  - apply Rlt_le, (R_vs_end K r phi beta d h alpha HK HF HS v w z x1 x2 c p t); assumption.
  - destruct (R_cell_swap K r beta d h HK v w z x1 x2 c p RC) as (p' & R' & E). rewrite <- E.
    apply Rlt_le. eapply (R_vs_end K r phi beta d h alpha HK HF HS w v z); [exact R'|exact Ht|exact Pl|exact J|exact I].
  - apply Rlt_le, (R_vs_disjoint K r phi beta d h alpha HK HF HS v w z x1 x2 c p t); assumption.
Qed.
End InFaceEdge.

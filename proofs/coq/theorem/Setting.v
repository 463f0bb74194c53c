(** Step (4) of theory.md section 3 always has a solution: for any admissible numbers of
    a complex there is a positive spacing h. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space Margins.
From Confidel.theorem Require Import Complex Placement.
Open Scope R_scope.

Theorem setting_exists r phi alpha : 0 < r -> 0 < phi <= PI / 4 -> 0 < alpha <= PI ->
  exists beta d h, 0 < h /\ setting r phi beta d h alpha.
Proof.
  intros Hr Hp Ha. pose proof PI_RGT_0.
  set (d := r * sin (phi / 3)). set (h1 := 2 * r * sin (phi / 12)). set (h2 := 2 / 3 * (2 * d * sin (alpha / 2))).
  assert (S1 : 0 < sin (phi / 3)) by (apply sin_gt_0; lra).
  assert (S2 : 0 < sin (phi / 12)) by (apply sin_gt_0; lra).
  assert (S3 : 0 < sin (alpha / 2)) by (apply sin_gt_0; lra).
  assert (D : 0 < d) by (apply Rmult_lt_0_compat; assumption).
  assert (H1 : 0 < h1) by (unfold h1; repeat apply Rmult_lt_0_compat; lra).
  assert (H2 : 0 < h2) by (unfold h2; repeat apply Rmult_lt_0_compat; lra).
  exists (phi / 3), d, (Rmin h1 h2).
  assert (H0 : 0 < Rmin h1 h2) by (apply Rmin_glb_lt; assumption).
  pose proof (Rmin_l h1 h2). pose proof (Rmin_r h1 h2).
  split; [exact H0|]. constructor.
  - repeat split; try lra. fold h1. lra.
  - lra.
  - unfold h2 in *. lra.
Qed.

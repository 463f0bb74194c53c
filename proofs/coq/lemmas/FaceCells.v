(** L16: the C cells, triangles of P'' with circumradius at most h, against the points
    that are not in their face's plane (paper section 3.2: "the circumradii of Chew's
    triangles ... do not intersect any other entity in the PLC, due to the bounds on
    the circumradii").

    Simpler than the paper: neither the depth bound L23 nor the alignment is needed off
    the plane. A triangle corner p with |p - c| <= h is far enough from everything, and
    at a common edge the dihedral gap works even for a centre behind the protector. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space DihedralGap Margins.
Open Scope R_scope.

(** A point more than 2h from one corner is outside. *)
Theorem C_vs_far c p x h : 0 < h -> dist c p <= h -> 2 * h < dist p x ->
  0 < power c p x.
Proof.
  intros Hh R F. unfold power. rewrite <- !dist_sqr.
  pose proof (dist_triangle p c x) as T. rewrite (dist_sym p c) in T.
  pose proof (dist_nonneg c p). assert (h < dist c x) by lra. nra.
Qed.

(** Against faces and edges at a vertex v (the origin) that share only v with the face:
    the corner p is at distance >= k = r cos beta from v, at angle >= phi from x. *)
Theorem C_vs_vertex c p x h k phi : 0 < h -> dist c p <= h ->
  0 <= k -> k * k <= norm2 p -> 0 <= phi <= PI / 2 -> 2 * h < k * sin phi ->
  dot p x <= norm p * norm x * cos phi -> 0 < power c p x.
Proof.
  intros Hh R K NP Hp S A. apply C_vs_far with (h := h); try assumption.
  assert (S0 : 0 <= sin phi) by (apply sin_ge_0; pose proof PI_RGT_0; lra).
  pose proof (norm_nonneg p) as N0. pose proof (norm_sqr p) as N2.
  assert (KP : k <= norm p) by (apply sq_le; lra).
  assert (D : (norm p * sin phi) * (norm p * sin phi) <= dist2 p x).
  { apply distance_from_angle; try assumption. symmetry. exact N2. }
  apply sq_lt; [apply dist_nonneg|]. rewrite dist_sqr.
  assert (k * sin phi <= norm p * sin phi) by (apply Rmult_le_compat_r; lra).
  apply Rlt_le_trans with ((norm p * sin phi) * (norm p * sin phi)); [|exact D].
  apply sq_lt_mono; lra.
Qed.

(** Against another face at a common edge e (line through the origin in direction u):
    corner p = k u + q o with q >= d, x = k' u + q' o' with q' >= d, d_f >= 3h/2. *)
Theorem C_vs_other_face u o o' c k q k' q' kc qc d a h :
  norm2 u = 1 -> norm2 o = 1 -> norm2 o' = 1 -> dot u o = 0 -> dot u o' = 0 -> dot o o' <= cos a ->
  0 < h -> 1978 / 1000 * h <= d -> d <= q -> d <= q' -> 0 <= a <= PI -> 3 / 2 * h <= 2 * d * sin (a / 2) ->
  let p := vadd (vscale k u) (vscale q o) in
  let x := vadd (vscale k' u) (vscale q' o') in
  c = vadd (vscale kc u) (vscale qc o) -> dist c p <= h -> 0 < power c p x.
Proof.
  intros U O O' UO UO' A Hh Hd Hq Hq' Ha G p x C R.
  (* the centre is at most h behind the corner *)
  assert (QC : d - h <= qc).
  { assert (D : dist2 c p = (kc - k) * (kc - k) + (qc - q) * (qc - q)).
    { subst c. unfold p. unfold dist2, norm2 in *.
      rewrite !dot_sub_l, !dot_sub_r, !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, (dot_comm o u), U, O, UO. ring. }
    pose proof (dist_sqr c p) as DS. pose proof (dist_nonneg c p).
    pose proof (Rle_0_sqr (kc - k)) as S. unfold Rsqr in S.
    assert ((qc - q) * (qc - q) <= h * h) by nra. nra. }
  assert (L : h * h < dist2 c x).
  { subst c. unfold x.
    eapply Rlt_le_trans; [|apply dihedral_gap_general with (a := a); try assumption; lra].
    set (s := sin (a / 2)) in *.
    assert (G2 : 9 / 4 * (h * h) <= 4 * (d * d) * (s * s)).
    { replace (9 / 4 * (h * h)) with ((3 / 2 * h) * (3 / 2 * h)) by field.
      replace (4 * (d * d) * (s * s)) with ((2 * d * s) * (2 * d * s)) by ring. apply sq_le_mono; lra. }
    (* qc q' >= (d - h) d >= 0.494 d^2 and 0.494 * 9/4 > 1 *)
    assert (Q : 494 / 1000 * (d * d) <= qc * q').
    { apply Rle_trans with ((d - h) * d); [nra|]. apply Rmult_le_compat; lra. }
    assert (0 <= s * s) by nra.
    assert (494 / 1000 * (d * d) * (s * s) <= qc * q' * (s * s)) by (apply Rmult_le_compat_r; lra). nra. }
  unfold power. rewrite <- (dist_sqr c p). pose proof (dist_nonneg c p). nra.
Qed.

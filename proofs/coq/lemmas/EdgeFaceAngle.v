(** Proposition G (theory.md section 2) and L15: what the paper's rule for d_e
    overlooks (section 3.2: "We do not take into account dihedral angles at this
    point"). The statements L10 (S against m_{e'}) are its consequences.

    The vertex v is the origin. A spoke triangle (v, p, q) of face F has its arc ends at
    distance r; b is the unit bisector, g the unit vector of F orthogonal to it, a the
    half-angle between p and q. n is the unit normal of F. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

Definition orthonormal2 b g := norm2 b = 1 /\ norm2 g = 1 /\ dot b g = 0.
Definition orthonormal3 b g n :=
  norm2 b = 1 /\ norm2 g = 1 /\ norm2 n = 1 /\ dot b g = 0 /\ dot b n = 0 /\ dot g n = 0.

(** The point of F in direction t from the bisector at distance k. *)
Definition in_face b g k t := vadd (vscale (k * cos t) b) (vscale (k * sin t) g).
Definition spoke_start b g r a := in_face b g r (- a).
Definition spoke_end b g r a := in_face b g r a.
Definition spoke_centre b r a := vscale (r / (2 * cos a)) b.

(** Power of x for the diametral sphere of the spoke triangle, apex v = 0. *)
Definition spoke_power b r a x := power (spoke_centre b r a) vzero x.

Lemma spoke_power_eq b r a x : cos a <> 0 -> norm2 b = 1 ->
  spoke_power b r a x = norm2 x - r / cos a * dot b x.
Proof.
  intros C B. unfold spoke_power, spoke_centre, power, dist2, norm2 in *.
  rewrite !dot_sub_l, !dot_sub_r, !dot_scale_l, !dot_scale_r, !dot_zero_l, !dot_zero_r.
  rewrite (dot_comm x b). field. exact C.
Qed.

Lemma norm2_in_face b g k t : orthonormal2 b g -> norm2 (in_face b g k t) = k * k.
Proof.
  intros (B & G & O). unfold in_face, norm2 in *.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, (dot_comm g b), B, G, O.
  pose proof (sin2_cos2 t) as E. unfold Rsqr in E.
  transitivity (k * k * (sin t * sin t + cos t * cos t)); [ring|rewrite E; ring].
Qed.

Lemma dot_in_face b g k t : orthonormal2 b g -> dot b (in_face b g k t) = k * cos t.
Proof.
  intros (B & G & O). unfold in_face, norm2 in *.
  rewrite dot_add_r, !dot_scale_r, B, O. ring.
Qed.

(** The centre is what it is called: in the plane of F and equidistant. *)
Theorem spoke_centre_correct b g n r a : orthonormal3 b g n -> cos a <> 0 ->
  dot n (spoke_centre b r a) = 0 /\
  spoke_power b r a (spoke_start b g r a) = 0 /\ spoke_power b r a (spoke_end b g r a) = 0.
Proof.
  intros (B & G & N & BG & BN & GN) C. assert (O : orthonormal2 b g) by (repeat split; assumption).
  split; [|split].
  - unfold spoke_centre. rewrite dot_scale_r, (dot_comm n b), BN. ring.
  - rewrite spoke_power_eq by assumption. unfold spoke_start.
    rewrite norm2_in_face, dot_in_face by exact O. rewrite cos_neg. field. exact C.
  - rewrite spoke_power_eq by assumption. unfold spoke_end.
    rewrite norm2_in_face, dot_in_face by exact O. field. exact C.
Qed.

(** Unit direction of an edge e' with tilt omega over F, its projection at longitude
    lambda from the bisector. *)
Definition tilted b g n omega lambda :=
  vadd (vscale (cos omega) (vadd (vscale (cos lambda) b) (vscale (sin lambda) g))) (vscale (sin omega) n).
(** m_{e'} = r cos(beta) u_{e'}. *)
Definition cap_point r beta u := vscale (r * cos beta) u.

Lemma tilted_unit b g n omega lambda : orthonormal3 b g n -> norm2 (tilted b g n omega lambda) = 1.
Proof.
  intros (B & G & N & BG & BN & GN). unfold tilted, norm2 in *.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r.
  rewrite (dot_comm g b), (dot_comm n b), (dot_comm n g), B, G, N, BG, BN, GN.
  pose proof (sin2_cos2 omega) as E. pose proof (sin2_cos2 lambda) as E2. unfold Rsqr in *.
  set (co := cos omega) in *. set (so := sin omega) in *.
  set (cl := cos lambda) in *. set (sl := sin lambda) in *.
  assert (X : co * co * (sl * sl + cl * cl) + so * so = 1) by (rewrite E2; lra).
  transitivity (co * co * (sl * sl + cl * cl) + so * so); [ring|exact X].
Qed.

Lemma dot_tilted b g n omega lambda : orthonormal3 b g n ->
  dot b (tilted b g n omega lambda) = cos omega * cos lambda.
Proof.
  intros (B & G & N & BG & BN & GN). unfold tilted, norm2 in *.
  rewrite !dot_add_r, !dot_scale_r, dot_add_r, !dot_scale_r, B, BG, BN. ring.
Qed.

Lemma spoke_power_on_edge b r a beta u : 0 < cos a -> norm2 b = 1 -> norm2 u = 1 ->
  spoke_power b r a (cap_point r beta u)
  = r * r * cos beta / cos a * (cos beta * cos a - dot b u).
Proof.
  intros C B U. rewrite spoke_power_eq by (assumption || lra). unfold cap_point, norm2 in *.
  rewrite dot_scale_l, !dot_scale_r, U. field. lra.
Qed.

(** The exact criterion: the spoke's sphere is free of m_{e'} iff
    cos(omega) cos(lambda) <= cos(beta) cos(s/2). *)
Theorem edge_face_criterion b g n r a beta omega lambda : orthonormal3 b g n ->
  0 < r -> 0 < cos a -> 0 < cos beta ->
  (~ strictly_inside (spoke_centre b r a) vzero (cap_point r beta (tilted b g n omega lambda))
   <-> cos omega * cos lambda <= cos beta * cos a).
Proof.
  intros O Hr Ha Hb. unfold strictly_inside.
  change (power (spoke_centre b r a) vzero) with (spoke_power b r a).
  rewrite spoke_power_on_edge; [|exact Ha|apply O|apply tilted_unit; exact O].
  rewrite dot_tilted by exact O.
  assert (P : 0 < r * r * cos beta / cos a) by (apply Rdiv_lt_0_compat; [repeat apply Rmult_lt_0_compat|]; assumption).
  set (k := r * r * cos beta / cos a) in *.
  set (x := cos beta * cos a) in *. set (z := cos omega * cos lambda) in *.
  split; intros H.
  - destruct (Rle_lt_dec z x); [assumption|]. exfalso. apply H. nra.
  - nra.
Qed.

(** Prop G: if beta_{e'} > omega, then whatever the radius and whatever the subdivision,
    the spoke triangle below e' (longitude within its half-angle) has m_{e'} strictly
    inside its diametral sphere. *)
Theorem prop_G b g n r a beta omega lambda : orthonormal3 b g n ->
  0 < r -> 0 < a < PI / 2 -> 0 <= omega < beta -> beta < PI / 2 -> - a <= lambda <= a ->
  strictly_inside (spoke_centre b r a) vzero (cap_point r beta (tilted b g n omega lambda)).
Proof.
  intros O Hr Ha Ho Hb Hl.
  assert (Ca : 0 < cos a) by (apply cos_gt_0; lra).
  assert (Cb : 0 < cos beta) by (apply cos_gt_0; lra).
  assert (Cob : cos beta < cos omega) by (apply cos_decreasing_1; lra).
  assert (Cla : cos a <= cos lambda).
  { destruct (Rle_dec 0 lambda); [apply cos_decr_1; lra|].
    rewrite <- (cos_neg lambda). apply cos_decr_1; lra. }
  unfold strictly_inside. change (power (spoke_centre b r a) vzero) with (spoke_power b r a).
  rewrite spoke_power_on_edge; [|exact Ca|apply O|apply tilted_unit; exact O].
  rewrite dot_tilted by exact O.
  assert (P : 0 < r * r * cos beta / cos a) by (apply Rdiv_lt_0_compat; [repeat apply Rmult_lt_0_compat|]; assumption).
  assert (cos beta * cos a < cos omega * cos lambda) by nra. nra.
Qed.

(** For two faces sharing an edge e at dihedral angle alpha, an edge e' of the second
    one at angle psi from e has tilt omega with sin omega = sin psi sin alpha: it goes
    to 0 with the dihedral. j is the direction of F orthogonal to e. *)
Theorem tilt_from_dihedral i j n psi alpha : orthonormal3 i j n ->
  let o' := vadd (vscale (cos alpha) j) (vscale (sin alpha) n) in
  let u' := vadd (vscale (cos psi) i) (vscale (sin psi) o') in
  dot u' n = sin psi * sin alpha.
Proof.
  intros (I & J & N & IJ & IN & JN) o' u'. unfold u', o', norm2 in *.
  rewrite dot_add_l, !dot_scale_l, dot_add_l, !dot_scale_l, IN, JN, N. ring.
Qed.

(** L15: an edge that makes at least the angle phi with every direction of F clears
    all spokes of F whose half-angle a satisfies cos phi <= cos beta cos a;
    beta = phi/3 and a <= phi/12 do (see Margins). *)
Theorem edge_face_clear b r a beta phi u s : norm2 b = 1 -> norm2 u = 1 ->
  0 < r -> 0 < cos a -> dot b u <= cos phi -> cos phi <= cos beta * cos a -> r * cos beta <= s -> 0 < s ->
  0 <= spoke_power b r a (vscale s u).
Proof.
  intros B U Hr Ca A C Hs Hs0. rewrite spoke_power_eq by (assumption || lra).
  unfold norm2 in *. rewrite dot_scale_l, !dot_scale_r, U.
  replace (s * (s * 1) - r / cos a * (s * dot b u)) with (s * (s - r * (dot b u / cos a))) by (field; lra).
  apply Rmult_le_pos; [lra|].
  assert (dot b u / cos a <= cos beta).
  { apply Rmult_le_reg_r with (cos a); [lra|]. replace (dot b u / cos a * cos a) with (dot b u) by (field; lra). lra. }
  nra.
Qed.

(** The same, strictly. *)
Theorem edge_face_clear_strict b r a beta phi u s : norm2 b = 1 -> norm2 u = 1 ->
  0 < r -> 0 < cos a -> dot b u <= cos phi -> cos phi < cos beta * cos a -> r * cos beta <= s -> 0 < s ->
  0 < spoke_power b r a (vscale s u).
Proof.
  intros B U Hr Ca A C Hs Hs0. rewrite spoke_power_eq by (assumption || lra).
  unfold norm2 in *. rewrite dot_scale_l, !dot_scale_r, U.
  replace (s * (s * 1) - r / cos a * (s * dot b u)) with (s * (s - r * (dot b u / cos a))) by (field; lra).
  apply Rmult_lt_0_compat; [lra|].
  assert (dot b u / cos a < cos beta).
  { apply Rmult_lt_reg_r with (cos a); [lra|]. replace (dot b u / cos a * cos a) with (dot b u) by (field; lra). lra. }
  nra.
Qed.

(** L3, spoke bulge (paper section 2.2: "its circumcircle extends a distance at most
    b/(2 sqrt 3) beyond the base").

    A circle through the ends (-b/2, 0), (b/2, 0) of a base is centred at (0, k),
    k being the signed distance from the base towards the apex. It reaches down to
    height k - R, so its bulge beyond the base is R - k. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

Definition bulge b k := sqrt (k * k + b * b / 4) - k.

Lemma bulge_root b k : let R := sqrt (k * k + b * b / 4) in 0 <= R /\ R * R = k * k + b * b / 4.
Proof. simpl. split; [apply sqrt_pos|apply sqrt_sqrt; nra]. Qed.

(** The bulge is what its name says: the circle stays above height -(bulge). *)
Theorem bulge_is_reach b k x y :
  x * x + (y - k) * (y - k) = k * k + b * b / 4 -> - bulge b k <= y.
Proof.
  intros C. unfold bulge. destruct (bulge_root b k) as [R0 RR].
  set (R := sqrt (k * k + b * b / 4)) in *. nra.
Qed.

(** The bulge is attained below the middle of the base. *)
Theorem bulge_attained b k :
  0 * 0 + (- bulge b k - k) * (- bulge b k - k) = k * k + b * b / 4.
Proof.
  unfold bulge. destruct (bulge_root b k) as [R0 RR].
  set (R := sqrt (k * k + b * b / 4)) in *. lra.
Qed.

(** Signed form (theory.md section 6): bulge <= h/2 iff b^2 - h^2 <= 4 h k. *)
Theorem bulge_le_half_iff b k h : 0 <= k + h / 2 ->
  (bulge b k <= h / 2 <-> b * b - h * h <= 4 * h * k).
Proof.
  intros Hk. unfold bulge. destruct (bulge_root b k) as [R0 RR].
  set (R := sqrt (k * k + b * b / 4)) in *. split; intros; nra.
Qed.

(** The exact form of L3 row by row: apex coordinates (A-v).(B-v) = D and
    |(A-v) x (B-v)|^2 = X give k = (b/2) cot(apex) = b D / (2 sqrt X); squaring
    needs the sign of k. *)
Theorem spoke_bulge_rational b k D X h : 0 < b -> 0 < h -> 0 < X -> 2 * k * sqrt X = b * D ->
  ((b * b <= h * h /\ 0 <= D) \/
   (0 < D /\ (b * b - h * h) * (b * b - h * h) * X <= 4 * (h * h) * (b * b) * (D * D))) ->
  bulge b k <= h / 2.
Proof.
  intros Hb Hh HX HK H.
  assert (SX : 0 < sqrt X) by (apply sqrt_lt_R0; exact HX).
  assert (SS : sqrt X * sqrt X = X) by (apply sqrt_sqrt; lra).
  set (S := sqrt X) in *.
  assert (K0 : 0 <= D -> 0 <= k) by (intros; nra).
  destruct H as [[H1 H2]|[H1 H2]].
  - specialize (K0 H2). apply bulge_le_half_iff; nra.
  - assert (0 <= k) by (apply K0; lra). apply bulge_le_half_iff; [lra|].
    apply sq_le; [nra|].
    replace (4 * (h * h) * (b * b) * (D * D)) with (4 * (h * h) * ((b * D) * (b * D))) in H2 by ring.
    rewrite <- HK, <- SS in H2.
    apply Rmult_le_reg_r with (S * S); [nra|]. nra.
Qed.

(** Isosceles triangle with apex angle a and base b: its circumcentre is at height
    k = (b/2) cot a, and the bulge is (b/2) tan(a/2). *)
Theorem isosceles_bulge b a : 0 < b -> 0 < a < PI ->
  bulge b (b / 2 * (cos a / sin a)) = b / 2 * tan (a / 2).
Proof.
  intros Hb Ha. unfold bulge.
  assert (S : 0 < sin a) by (apply sin_gt_0; lra).
  assert (C2 : 0 < cos (a / 2)) by (apply cos_gt_0; lra).
  assert (S2 : 0 < sin (a / 2)) by (apply sin_gt_0; lra).
  pose proof (sin2_cos2 a) as E. unfold Rsqr in E.
  assert (K : b / 2 * (cos a / sin a) * (b / 2 * (cos a / sin a)) + b * b / 4
              = (b / (2 * sin a)) * (b / (2 * sin a))).
  { replace (b * b / 4) with (b * b / 4 * (sin a * sin a + cos a * cos a) / (sin a * sin a)
      - b * b / 4 * (cos a * cos a) / (sin a * sin a)) by (field; lra).
    rewrite E. field. lra. }
  rewrite K, sqrt_square.
  2:{ apply Rlt_le, Rdiv_lt_0_compat; lra. }
  unfold tan. replace (sin a) with (2 * sin (a / 2) * cos (a / 2)).
  2:{ rewrite <- sin_2a. f_equal. field. }
  replace (cos a) with (1 - 2 * sin (a / 2) * sin (a / 2)).
  2:{ rewrite <- cos_2a_sin. f_equal. field. }
  field. lra.
Qed.

Lemma tan_le_at_pi6 a : 0 < a <= PI / 3 -> tan (a / 2) * sqrt 3 <= 1.
Proof.
  intros Ha. pose proof PI_RGT_0. pose proof sqrt3_pos.
  assert (T : tan (a / 2) <= tan (PI / 6)).
  { destruct (Req_dec a (PI / 3)) as [->|N]; [right; f_equal; field|].
    left. apply tan_increasing; lra. }
  rewrite tan_PI6 in T. apply Rmult_le_compat_r with (r := sqrt 3) in T; [|lra].
  replace (1 / sqrt 3 * sqrt 3) with 1 in T by (field; lra). exact T.
Qed.

(** L3 as in the paper: apex angle at most pi/3 gives bulge <= b/(2 sqrt 3), hence
    <= h/2 when b <= sqrt 3 h. *)
Theorem spoke_bulge b a h : 0 < b -> 0 < a <= PI / 3 -> b <= sqrt 3 * h ->
  let k := b / 2 * (cos a / sin a) in
  bulge b k <= b / (2 * sqrt 3) /\ bulge b k <= h / 2.
Proof.
  intros Hb Ha Hbh k. pose proof PI_RGT_0. unfold k. rewrite isosceles_bulge by lra.
  pose proof (tan_le_at_pi6 a Ha) as T. pose proof sqrt3_sqr. pose proof sqrt3_pos.
  set (t := tan (a / 2)) in *.
  assert (A : b / 2 * t <= b / (2 * sqrt 3)).
  { replace (b / (2 * sqrt 3)) with (b / 2 * (1 / sqrt 3)) by (field; lra).
    apply Rmult_le_compat_l; [lra|]. apply Rmult_le_reg_r with (sqrt 3); [lra|].
    replace (1 / sqrt 3 * sqrt 3) with 1 by (field; lra). exact T. }
  split; [exact A|].
  assert (b / (2 * sqrt 3) * (2 * sqrt 3) = b) by (field; lra). nra.
Qed.

(** In terms of radius and chord: apex at distance r from both ends of a chord b;
    k = (r^2 - b^2/2) / (2 sqrt(r^2 - b^2/4)). The form used for the margins. *)
Theorem spoke_bulge_radius r a : 0 < r -> 0 < a < PI / 2 ->
  let b := 2 * r * sin (a / 2) in
  bulge b (b / 2 * (cos a / sin a)) = r / cos (a / 2) - r * cos (a / 2).
Proof.
  intros Hr Ha b. pose proof PI_RGT_0.
  assert (0 < sin (a / 2)) by (apply sin_gt_0; lra).
  assert (0 < cos (a / 2)) by (apply cos_gt_0; lra).
  rewrite isosceles_bulge; [|unfold b; nra|lra]. unfold b, tan.
  pose proof (sin2_cos2 (a / 2)) as E. unfold Rsqr in E.
  apply Rmult_eq_reg_r with (cos (a / 2)); [|lra].
  replace ((r / cos (a / 2) - r * cos (a / 2)) * cos (a / 2)) with (r * (1 - cos (a / 2) * cos (a / 2))) by (field; lra).
  rewrite <- E. field. lra.
Qed.

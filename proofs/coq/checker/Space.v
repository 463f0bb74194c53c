(* SPDX-License-Identifier: Apache-2.0 *)
(** * Points of real three-space: the vocabulary of the statement. *)
From Coq Require Import Reals Lra.
Open Scope R_scope.

Record point := Point { cx : R; cy : R; cz : R }.

Definition origin := Point 0 0 0.
Definition minus a b := Point (cx a - cx b) (cy a - cy b) (cz a - cz b).
Definition dot a b := cx a * cx b + cy a * cy b + cz a * cz b.
Definition cross a b :=
  Point (cy a * cz b - cz a * cy b) (cz a * cx b - cx a * cz b) (cx a * cy b - cy a * cx b).
(** squared distance *)
Definition dist2 a b := dot (minus a b) (minus a b).
(** the point a + s (b - a) *)
Definition towards a b s :=
  Point (cx a + s * (cx b - cx a)) (cy a + s * (cy b - cy a)) (cz a + s * (cz b - cz a)).
(** weighted sums of three and of four points *)
Definition mix3 a b c l m n :=
  Point (l * cx a + m * cx b + n * cx c) (l * cy a + m * cy b + n * cy c) (l * cz a + m * cz b + n * cz c).
Definition mix4 a b c d l m n k :=
  Point (l * cx a + m * cx b + n * cx c + k * cx d)
        (l * cy a + m * cy b + n * cy c + k * cy d)
        (l * cz a + m * cz b + n * cz c + k * cz d).

(** the closed segment a b, the closed triangle a b c *)
Definition on_segment a b x := exists s, 0 <= s <= 1 /\ x = towards a b s.
Definition in_triangle a b c x :=
  exists l m n, 0 <= l /\ 0 <= m /\ 0 <= n /\ l + m + n = 1 /\ x = mix3 a b c l m n.
Definition collinear a b c := cross (minus b a) (minus c a) = origin.

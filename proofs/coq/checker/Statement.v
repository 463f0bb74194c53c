(* SPDX-License-Identifier: Apache-2.0 *)
(** * What a certificate claims

    The complex of docs/certificate-format.md section 2, the Delaunay subdivisions of a set of points, and [conforms] of section 4.
    Nothing here speaks of certificates, cells or checks: this page and the theorem [Sound.check_sound] are all that has to be read.
    Only the axioms of the real numbers of Coq are used. *)
From Coq Require Import ZArith List Bool Reals.
From Confidel.checker Require Import Space.
Import ListNotations.
Open Scope R_scope.

(** ** The complex, as it stands in the file *)

(** A point [v X Y Z W] of the file: integers, meaning (X/W, Y/W, Z/W). In dimension 2 the reader sets Z = 0. *)
Record hpoint := HPoint { hx : Z; hy : Z; hz : Z; hw : Z }.
Definition real (p : hpoint) : point :=
  Point (IZR (hx p) / IZR (hw p)) (IZR (hy p) / IZR (hw p)) (IZR (hz p) / IZR (hw p)).

(** Vertices, segments and facets are numbered from 1: the vertex with index i in the file is number i + 1. *)
Definition number := positive.
Record facet := Facet {
  f_i : number; f_j : number; f_k : number;     (** the plane:             [f i j k] *)
  f_boundary : list (number * number);          (** directed:              [b M] and its lines *)
  f_inner : list (number * number);             (** inner constraints:     [c M] and its lines *)
  f_isolated : list number }.                   (** isolated vertices:     [p M] and its lines *)
Record complex := Complex {
  c_vertices : list hpoint;
  c_segments : list (number * number);
  c_facets : list facet }.

(** Where vertex number [v] is. (The check rejects numbers that do not exist.) *)
Definition place (K : complex) (v : number) : point :=
  real (nth (Pos.to_nat v - 1) (c_vertices K) (HPoint 0 0 0 1)).

(** ** The region of a facet: what lies to the left of its boundary *)

(** Coordinates in the facet's plane: origin P_i, first axis e = P_j - P_i, second axis n x e, where n = e x (P_k - P_i). *)
Definition normal (a b c : point) := cross (minus b a) (minus c a).
Definition planar (a b c x : point) : R * R :=
  (dot (minus b a) (minus x a), dot (cross (normal a b c) (minus b a)) (minus x a)).
Definition in_plane (a b c x : point) := dot (normal a b c) (minus x a) = 0.

(** Twice the signed area of a triangle; how often the directed edge p q crosses the ray from x in direction of the first axis:
    1 from below to above, -1 from above to below, 0 else. The sum over closed loops is the winding number around x. *)
Definition area2 (p q r : R * R) := (fst q - fst p) * (snd r - snd p) - (snd q - snd p) * (fst r - fst p).
Definition below (s t : R) : bool := if Rlt_dec s t then true else false.
Definition crossing (x p q : R * R) : Z :=
  if negb (below (snd x) (snd p)) && below (snd x) (snd q) && below 0 (area2 p q x) then 1%Z
  else if negb (below (snd x) (snd q)) && below (snd x) (snd p) && below (area2 p q x) 0 then (-1)%Z
  else 0%Z.
Definition winding (edges : list ((R * R) * (R * R))) (x : R * R) : Z :=
  fold_right (fun e s => (crossing x (fst e) (snd e) + s)%Z) 0%Z edges.

Definition facet_plane K F := in_plane (place K (f_i F)) (place K (f_j F)) (place K (f_k F)).
Definition facet_planar K F := planar (place K (f_i F)) (place K (f_j F)) (place K (f_k F)).
Definition facet_winding K F (x : point) : Z :=
  winding (map (fun e => (facet_planar K F (place K (fst e)), facet_planar K F (place K (snd e)))) (f_boundary F))
          (facet_planar K F x).
(** The closed region: the closure, in the facet's plane, of the points around which the boundary winds. *)
Definition region K F (x : point) :=
  facet_plane K F x /\
  forall eps, 0 < eps -> exists y, dist2 x y < eps /\ facet_plane K F y /\ facet_winding K F y <> 0%Z.

(** ** Delaunay subdivisions *)

(** A tetrahedron p q r s. A triangle of a planar subdivision is written p q r r. *)
Definition simplex := (point * point * point * point)%type.
Definition corner (t : simplex) v := let '(p, q, r, s) := t in v = p \/ v = q \/ v = r \/ v = s.
Definition in_simplex (t : simplex) x := let '(p, q, r, s) := t in
  exists l m n k, 0 <= l /\ 0 <= m /\ 0 <= n /\ 0 <= k /\ l + m + n + k = 1 /\ x = mix4 p q r s l m n k.
(** the face of [t] spanned by those of its corners that satisfy [P] *)
Definition in_face (t : simplex) (P : point -> Prop) x := let '(p, q, r, s) := t in
  exists l m n k, 0 <= l /\ 0 <= m /\ 0 <= n /\ 0 <= k /\ l + m + n + k = 1 /\ x = mix4 p q r s l m n k /\
    (l = 0 \/ P p) /\ (m = 0 \/ P q) /\ (n = 0 \/ P r) /\ (k = 0 \/ P s).
Definition solid (t : simplex) := let '(p, q, r, s) := t in dot (normal p q r) (minus s p) <> 0.
Definition flat (t : simplex) := let '(p, q, r, s) := t in s = r /\ ~ collinear p q r.

(** the convex hull *)
Inductive hull (V : list point) : point -> Prop :=
| hull_in v : In v V -> hull V v
| hull_towards x y s : 0 <= s <= 1 -> hull V x -> hull V y -> hull V (towards x y s).

(** [o] is the centre of a sphere through all corners of [t] whose open ball contains no point of [V] *)
Definition empty_ball (V : list point) (t : simplex) o :=
  forall u, corner t u -> (forall w, corner t w -> dist2 o w = dist2 o u) /\ forall v, In v V -> dist2 o u <= dist2 o v.

Record subdivision (shape : simplex -> Prop) (V : list point) (T : list simplex) : Prop := {
  sub_corners : forall t v, In t T -> corner t v -> In v V;
  sub_shape : forall t, In t T -> shape t;
  sub_empty : forall t, In t T -> exists o, empty_ball V t o;
  sub_covers : forall x, hull V x <-> exists t, In t T /\ in_simplex t x;
  sub_meets : forall t u x, In t T -> In u T -> in_simplex t x -> in_simplex u x -> in_face t (corner u) x }.

(** A Delaunay subdivision of [V] into tetrahedra; into triangles, if [V] lies in a plane. *)
Definition delaunay := subdivision solid.
Definition delaunay_planar := subdivision flat.

(** ** Conformity *)
Definition vertex_of (T : list simplex) v := exists t, In t T /\ corner t v.
Definition edge_of (T : list simplex) u v := u <> v /\ exists t, In t T /\ corner t u /\ corner t v.
Definition face_of (T : list simplex) u v w :=
  ~ collinear u v w /\ exists t, In t T /\ corner t u /\ corner t v /\ corner t w.

(** Every vertex is a vertex of [T], every segment a union of edges of [T], every facet a union of faces of [T]. *)
Definition conforms (K : complex) (T : list simplex) :=
  (forall p, In p (c_vertices K) -> vertex_of T (real p)) /\
  (forall a b x, In (a, b) (c_segments K) -> on_segment (place K a) (place K b) x ->
     exists u v, edge_of T u v /\ on_segment u v x /\
       forall y, on_segment u v y -> on_segment (place K a) (place K b) y) /\
  (forall F x, In F (c_facets K) -> region K F x ->
     exists u v w, face_of T u v w /\ in_triangle u v w x /\
       forall y, in_triangle u v w y -> region K F y).

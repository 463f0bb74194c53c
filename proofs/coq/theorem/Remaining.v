(** Goals: what separates [Theorem31.theorem_3_1_repaired] from the paper's Theorem 3.1.
    NOT part of the trusted build; `make remaining` compiles it. Nothing may import it. *)
From Coq Require Import Reals Lra List.
From Confidel.lemmas Require Import Space Pencil EdgeCells.
From Confidel.theorem Require Import Complex Placement FaceGeometry InFace Theorem31.
Import ListNotations.
Open Scope R_scope.

(** Goal 1 (theory.md section 3, (2)): phi* need only be measured between edges and between
    edges and faces; two faces that share one corner are never closer. Proof idea: on the
    sphere about v two disjoint arcs shorter than pi have their least distance at an end
    of one of them (an interior critical pair is a saddle). *)
Definition link_of_edges K phi := forall v s t x y, has K s -> has K t -> meet_only_at v s t ->
  (exists a b, s = Seg a b) -> sector v s x -> sector v t y -> dot x y <= norm x * norm y * cos phi.
Theorem face_face_angle K phi : simplicial K -> 0 < phi <= PI / 4 -> link_of_edges K phi ->
  forall v s t x y, has K s -> has K t -> meet_only_at v s t -> sector v s x -> sector v t y ->
  dot x y <= norm x * norm y * cos phi.
Admitted.

(** Goal 2: a finite complex has positive features (compactness of simplices). *)
Theorem features_exist K : simplicial K ->
  exists r phi alpha, 0 < r /\ 0 < phi <= PI / 4 /\ 0 < alpha <= PI /\ features K r phi alpha.
Admitted.

(** Goal 3: "consecutive" implies legal, assembled. That arc points and protectors are placed
    is proved (PlacedArcs, PlacedPoints), and so are the parts of legality (Legality: arcs
    and protectors at the same corner, far points, arcs at a rectangle's end). Left: the
    case distinction over the six readings of the face, and rectangles against the
    protectors of the face's other two edges. *)
Definition boundary_point r beta d v w z x :=
  (exists theta t, corner_angle v w z theta /\ beta <= t <= theta - beta /\ x = vadd v (arc_vec r v w z t)) \/
  (exists k, r * cos beta <= k <= dist v w - r * cos beta /\
     x = vadd v (vadd (vscale k (dir v w)) (vscale d (offset v w z)))).
Theorem consecutive_spokes_are_legal K r phi beta d h alpha v w z t1 t2 c p a b e x :
  simplicial K -> features K r phi alpha -> setting r phi beta d h alpha ->
  S_cell K r beta h v w z t1 t2 c p -> same_tri v w z a b e -> boundary_point r beta d a b e x ->
  (forall t, t1 < t < t2 -> x <> vadd v (arc_vec r v w z t)) ->
  dot (arc_vec 1 v w z ((t1 + t2) / 2)) (vsub x v) <= norm (vsub x v) * cos ((t2 - t1) / 2) \/
  clear_of h (vadd v (arc_vec r v w z t1)) (vadd v (arc_vec r v w z t2)) x.
Admitted.
Theorem consecutive_rectangles_are_legal K r phi beta d h alpha v w z x1 x2 c p a b e x :
  simplicial K -> features K r phi alpha -> setting r phi beta d h alpha ->
  R_cell K r beta d h v w z x1 x2 c p -> same_tri v w z a b e -> boundary_point r beta d a b e x ->
  (forall k, x1 < k < x2 -> x <> vadd v (vadd (vscale k (dir v w)) (vscale d (offset v w z)))) ->
  EdgeCells.not_between x1 x2 (dot (dir v w) (vsub x v)) \/
  clear_of h (vadd v (vadd (vscale x1 (dir v w)) (vscale d (offset v w z))))
             (vadd v (vadd (vscale x2 (dir v w)) (vscale d (offset v w z)))) x.
Admitted.

(** Goal 4 (Chew's refinement): inner points can be chosen so that all is legal. With the
    boundary points of the faces' buffers fixed in B (finite, placed), there are finitely
    many inner points, clear of every boundary segment of B by h/2, such that a triangle
    of a face whose circle is empty in its plane and whose interior avoids the buffer has
    circumradius at most h. ChewLemma.chew_clean is the step; termination is packing (points
    pairwise >= h apart in a bounded set); existence of planar Delaunay triangulations is
    not needed for this form, only for Goal 5. *)
Definition finite_set (P : point_set) := exists l : list vec, forall t x, P t x -> In x l.
Definition empty_in_plane (P : point_set) v w z a b c o :=
  diametral_centre o a b c /\ C_legal P v w z o a.
(** Boundary segments of P'': chords of the arcs and intervals of the protectors. *)
Definition boundary_segment K (B : point_set) r beta d h v w z p q :=
  (exists t1 t2 c p', S_cell K r beta h v w z t1 t2 c p' /\ S_legal B r h v w z t1 t2 /\
     p = vadd v (arc_vec r v w z t1) /\ q = vadd v (arc_vec r v w z t2)) \/
  (exists x1 x2 c p', R_cell K r beta d h v w z x1 x2 c p' /\ R_legal B d h v w z x1 x2 /\
     p = vadd v (vadd (vscale x1 (dir v w)) (vscale d (offset v w z))) /\
     q = vadd v (vadd (vscale x2 (dir v w)) (vscale d (offset v w z)))).
(** B has all of the boundary: arcs and protectors without gaps, points >= h apart. *)
Definition buffer_complete K (B : point_set) r beta d h :=
  (forall v w z theta t, has K (Tri v w z) -> corner_angle v w z theta -> beta <= t <= theta - beta ->
     exists t1 t2 c p, S_cell K r beta h v w z t1 t2 c p /\ S_legal B r h v w z t1 t2 /\ t1 <= t <= t2 /\
       B (Tri v w z) (vadd v (arc_vec r v w z t1)) /\ B (Tri v w z) (vadd v (arc_vec r v w z t2))) /\
  (forall v w z k, has K (Tri v w z) -> r * cos beta <= k <= dist v w - r * cos beta ->
     exists x1 x2 c p, R_cell K r beta d h v w z x1 x2 c p /\ R_legal B d h v w z x1 x2 /\ x1 <= k <= x2 /\
       B (Tri v w z) (vadd v (vadd (vscale x1 (dir v w)) (vscale d (offset v w z)))) /\
       B (Tri v w z) (vadd v (vadd (vscale x2 (dir v w)) (vscale d (offset v w z))))) /\
  (forall v w z x y, has K (Tri v w z) -> B (Tri v w z) x -> B (Tri v w z) y -> x <> y -> h <= dist x y).
(** The buffer: nearer than d to an edge, or before a chord as seen from its vertex. *)
Definition in_buffer K (B : point_set) r beta d h v w z x :=
  exists v' w' z', same_tri v w z v' w' z' /\
    (dot (offset v' w' z') (vsub x v') < d \/
     exists t1 t2 c p, S_cell K r beta h v' w' z' t1 t2 c p /\ S_legal B r h v' w' z' t1 t2 /\
       let b := arc_vec 1 v' w' z' ((t1 + t2) / 2) in let a := (t2 - t1) / 2 in
       norm (vsub x v') * cos a <= dot b (vsub x v') < r * cos a).
Theorem chew_refinement K r phi beta d h alpha (B : point_set) :
  simplicial K -> features K r phi alpha -> setting r phi beta d h alpha -> finite_set B ->
  placement K r beta d B -> buffer_complete K B r beta d h ->
  exists P : point_set, finite_set P /\ placement K r beta d P /\ (forall t x, B t x -> P t x) /\
    (forall t x, P t x -> ~ B t x -> exists v w z, t = Tri v w z /\
       forall v' w' z' p q, same_tri v w z v' w' z' -> boundary_segment K B r beta d h v' w' z' p q -> clear_of h p q x) /\
    (forall v w z a b c o, has K (Tri v w z) -> P (Tri v w z) a -> P (Tri v w z) b -> P (Tri v w z) c ->
       empty_in_plane P v w z a b c o ->
       (forall x, in_simplex (Tri a b c) x -> in_simplex (Tri v w z) x /\ ~ in_buffer K B r beta d h v w z x) ->
       dist o a <= h).
Admitted.

(** Goal 5, the summit (Theorem 3.1 repaired, existence and tiling): every finite complex has
    a finite set of points such that every face is covered by triangles on its points,
    every edge of a face by their sides, all with empty diametral spheres, closed off
    the face (L18, L19). *)
Definition carried (P : point_set) v w z x := exists t, P t x /\ incl (corners t) [v; w; z].
Definition empty_triangle (P : point_set) v w z a b c :=
  carried P v w z a /\ carried P v w z b /\ carried P v w z c /\ nondegenerate a b c /\
  (forall x, in_simplex (Tri a b c) x -> in_simplex (Tri v w z) x) /\
  exists o, diametral_centre o a b c /\ forall t x, P t x ->
    ~ strictly_inside o a x /\ (~ incl (corners t) [v; w; z] -> 0 < power o a x).
Theorem conforming_points_exist K : simplicial K ->
  exists P : point_set, finite_set P /\
    (forall t x, P t x -> has K t /\ in_simplex t x) /\
    (forall v, has K (Pt v) -> P (Pt v) v) /\
    (forall v w z x, has K (Tri v w z) -> in_simplex (Tri v w z) x ->
       exists a b c, empty_triangle P v w z a b c /\ in_simplex (Tri a b c) x) /\
    (forall v w z x, has K (Tri v w z) -> in_simplex (Seg v w) x ->
       exists a b c, empty_triangle P v w z a b c /\ in_simplex (Seg a b) x /\
         forall y, in_simplex (Seg a b) y -> in_simplex (Seg v w) y).
Admitted.

(** Goal 6 (Lemma 1.2): with L18b (in-plane ties do not cross constraints) this makes every
    Delaunay subdivision of the points conform to K. The certificate's form of this step
    is the verified checker's soundness theorem (proofs/coq/checker); the instance for
    Goal 5's point set follows from that theorem's lemmas once Goal 5 is there. *)

(* SPDX-License-Identifier: Apache-2.0 *)
(** Extraction of the check. Integers become zarith's, by the nine lines below; everything else is what Coq generates. Part of the trusted base.
    Integers have no constructors here: code that needed one would not compile. Numbers of vertices are Coq's [positive], not integers.
    The last lines are functions that Coq writes out although nothing calls them any more. *)
From Coq Require Import ZArith FMapPositive Extraction ExtrOcamlBasic.
From Confidel.checker Require Import Statement Check.
Extraction Language OCaml.
Extract Inductive Z => "Zint.t" [ "No_integer_constructor" "No_integer_constructor" "No_integer_constructor" ] "no_integer_match".
Extract Inlined Constant Z.add => "Zint.add".
Extract Inlined Constant Z.sub => "Zint.sub".
Extract Inlined Constant Z.mul => "Zint.mul".
Extract Inlined Constant Z.eqb => "Zint.equal".
Extract Inlined Constant Z.leb => "Zint.leq".
Extract Inlined Constant Z.ltb => "Zint.lt".
Extract Inlined Constant zero => "Zint.zero".
Extract Inlined Constant one => "Zint.one".
Extract Inlined Constant two => "Zint.two".
Extract Inlined Constant Z.double => "Zint.unused".
Extract Inlined Constant Z.succ_double => "Zint.unused".
Extract Inlined Constant Z.pred_double => "Zint.unused".
Extract Inlined Constant Z.pos_sub => "Zint.unused".
Extract Inlined Constant Z.opp => "Zint.unused".
Extract Inlined Constant Z.compare => "Zint.unused".
Extraction "check.ml" check
  same_point between load_vertices load_steiner load_segments load_pairs context_of plane_of on_plane cell_shape cell_sphere locate tiling_ok judge query
  facet_vertices_ok hanging_ok subsegment_ok segment_between used mem power diametral common vsub vcross smallest corner_in.

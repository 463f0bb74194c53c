(* Written by check.sh: the axioms of every theorem of the trusted part. *)
Require Confidel.lemmas.Alignment.
Require Confidel.lemmas.ArcSpacing.
Require Confidel.lemmas.BoxBulge.
Require Confidel.lemmas.ChewClearance.
Require Confidel.lemmas.ChewLemma.
Require Confidel.lemmas.DihedralGap.
Require Confidel.lemmas.EdgeCells.
Require Confidel.lemmas.EdgeFaceAngle.
Require Confidel.lemmas.EdgeSpacing.
Require Confidel.lemmas.FaceCells.
Require Confidel.lemmas.LiteralRule.
Require Confidel.lemmas.LiteralRuleMore.
Require Confidel.lemmas.Margins.
Require Confidel.lemmas.Pencil.
Require Confidel.lemmas.Protectors.
Require Confidel.lemmas.Space.
Require Confidel.lemmas.SpokeBulge.
Require Confidel.lemmas.VertexCells.
Require Confidel.theorem.Complex.
Require Confidel.theorem.FaceGeometry.
Require Confidel.theorem.InFace.
Require Confidel.theorem.InFaceEdge.
Require Confidel.theorem.Legality.
Require Confidel.theorem.OffFaceEdge.
Require Confidel.theorem.OffFaceVertex.
Require Confidel.theorem.PlacedArcs.
Require Confidel.theorem.PlacedPoints.
Require Confidel.theorem.Placement.
Require Confidel.theorem.Separation.
Require Confidel.theorem.Setting.
Require Confidel.theorem.Theorem31.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.align_2D". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.align_2D.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.align_2D_any_row". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.align_2D_any_row.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.depth_bound". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.depth_bound.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.depth_bound_needs_third_vertex". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.depth_bound_needs_third_vertex.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.buffer_penetration". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.buffer_penetration.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.align_3D_iff". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.align_3D_iff.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_affine". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.aligned_ok_affine.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_rectangle". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.aligned_ok_rectangle.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_vector". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.aligned_ok_vector.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_equal_offsets". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.aligned_ok_equal_offsets.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_larger". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.aligned_ok_larger.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_smaller". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.aligned_ok_smaller.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.align_3D". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.align_3D.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.align_3D_fails_for_smaller_offset". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.align_3D_fails_for_smaller_offset.
Goal True. idtac "THEOREM Confidel.lemmas.Alignment.align_3D_all_centres". exact I. Qed. Print Assumptions Confidel.lemmas.Alignment.align_3D_all_centres.
Goal True. idtac "THEOREM Confidel.lemmas.ArcSpacing.arc_subdivision". exact I. Qed. Print Assumptions Confidel.lemmas.ArcSpacing.arc_subdivision.
Goal True. idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_range". exact I. Qed. Print Assumptions Confidel.lemmas.ArcSpacing.chord_range.
Goal True. idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_range_sqrt3". exact I. Qed. Print Assumptions Confidel.lemmas.ArcSpacing.chord_range_sqrt3.
Goal True. idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_le_half_radius". exact I. Qed. Print Assumptions Confidel.lemmas.ArcSpacing.chord_le_half_radius.
Goal True. idtac "THEOREM Confidel.lemmas.ArcSpacing.arc_spacing". exact I. Qed. Print Assumptions Confidel.lemmas.ArcSpacing.arc_spacing.
Goal True. idtac "THEOREM Confidel.lemmas.ArcSpacing.arc_spacing_repaired". exact I. Qed. Print Assumptions Confidel.lemmas.ArcSpacing.arc_spacing_repaired.
Goal True. idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_range_needs_exact_h". exact I. Qed. Print Assumptions Confidel.lemmas.ArcSpacing.chord_range_needs_exact_h.
Goal True. idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_is_reach". exact I. Qed. Print Assumptions Confidel.lemmas.BoxBulge.box_bulge_is_reach.
Goal True. idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_le_half". exact I. Qed. Print Assumptions Confidel.lemmas.BoxBulge.box_bulge_le_half.
Goal True. idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_rational". exact I. Qed. Print Assumptions Confidel.lemmas.BoxBulge.box_bulge_rational.
Goal True. idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_own_subdivision". exact I. Qed. Print Assumptions Confidel.lemmas.BoxBulge.box_bulge_own_subdivision.
Goal True. idtac "THEOREM Confidel.lemmas.ChewClearance.segment_clearance". exact I. Qed. Print Assumptions Confidel.lemmas.ChewClearance.segment_clearance.
Goal True. idtac "THEOREM Confidel.lemmas.ChewClearance.segment_clearance_closed". exact I. Qed. Print Assumptions Confidel.lemmas.ChewClearance.segment_clearance_closed.
Goal True. idtac "THEOREM Confidel.lemmas.ChewClearance.chew_clearance". exact I. Qed. Print Assumptions Confidel.lemmas.ChewClearance.chew_clearance.
Goal True. idtac "THEOREM Confidel.lemmas.ChewClearance.chew_clearance_own_subdivision". exact I. Qed. Print Assumptions Confidel.lemmas.ChewClearance.chew_clearance_own_subdivision.
Goal True. idtac "THEOREM Confidel.lemmas.ChewLemma.segment_does_not_separate". exact I. Qed. Print Assumptions Confidel.lemmas.ChewLemma.segment_does_not_separate.
Goal True. idtac "THEOREM Confidel.lemmas.ChewLemma.chew_clean". exact I. Qed. Print Assumptions Confidel.lemmas.ChewLemma.chew_clean.
Goal True. idtac "THEOREM Confidel.lemmas.ChewLemma.chew_clean_far_from_vertices". exact I. Qed. Print Assumptions Confidel.lemmas.ChewLemma.chew_clean_far_from_vertices.
Goal True. idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap_general". exact I. Qed. Print Assumptions Confidel.lemmas.DihedralGap.dihedral_gap_general.
Goal True. idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap". exact I. Qed. Print Assumptions Confidel.lemmas.DihedralGap.dihedral_gap.
Goal True. idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap_attained". exact I. Qed. Print Assumptions Confidel.lemmas.DihedralGap.dihedral_gap_attained.
Goal True. idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap_rational". exact I. Qed. Print Assumptions Confidel.lemmas.DihedralGap.dihedral_gap_rational.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.R_corners". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.R_corners.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.R_alignment_iff". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.R_alignment_iff.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_aligned". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.R_vs_aligned.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.offset_passes". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.offset_passes.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_other_face". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.R_vs_other_face.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_own_face". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.R_vs_own_face.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_far". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.R_vs_far.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_directions". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeCells.R_vs_directions.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.spoke_centre_correct". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeFaceAngle.spoke_centre_correct.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.edge_face_criterion". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeFaceAngle.edge_face_criterion.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.prop_G". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeFaceAngle.prop_G.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.tilt_from_dihedral". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeFaceAngle.tilt_from_dihedral.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.edge_face_clear". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeFaceAngle.edge_face_clear.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.edge_face_clear_strict". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeFaceAngle.edge_face_clear_strict.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeSpacing.edge_spacing". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeSpacing.edge_spacing.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeSpacing.edge_spacing_sqrt3". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeSpacing.edge_spacing_sqrt3.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeSpacing.edge_has_two_intervals". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeSpacing.edge_has_two_intervals.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeSpacing.aligned_row_spacing". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeSpacing.aligned_row_spacing.
Goal True. idtac "THEOREM Confidel.lemmas.EdgeSpacing.aligned_cell_is_rectangle". exact I. Qed. Print Assumptions Confidel.lemmas.EdgeSpacing.aligned_cell_is_rectangle.
Goal True. idtac "THEOREM Confidel.lemmas.FaceCells.C_vs_far". exact I. Qed. Print Assumptions Confidel.lemmas.FaceCells.C_vs_far.
Goal True. idtac "THEOREM Confidel.lemmas.FaceCells.C_vs_vertex". exact I. Qed. Print Assumptions Confidel.lemmas.FaceCells.C_vs_vertex.
Goal True. idtac "THEOREM Confidel.lemmas.FaceCells.C_vs_other_face". exact I. Qed. Print Assumptions Confidel.lemmas.FaceCells.C_vs_other_face.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRule.W3_phi". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRule.W3_phi.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRule.W3_literal_rule_fails". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRule.W3_literal_rule_fails.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRule.W3_phi_third". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRule.W3_phi_third.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRule.W3_phi_quarter". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRule.W3_phi_quarter.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRule.G3_phi". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRule.G3_phi.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRuleMore.literal_2D_protectors_cross". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRuleMore.literal_2D_protectors_cross.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRuleMore.repaired_2D_protectors". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRuleMore.repaired_2D_protectors.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRuleMore.W2_phi". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRuleMore.W2_phi.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRuleMore.W2_diametral_spheres_fail". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRuleMore.W2_diametral_spheres_fail.
Goal True. idtac "THEOREM Confidel.lemmas.LiteralRuleMore.W2_rational_witness". exact I. Qed. Print Assumptions Confidel.lemmas.LiteralRuleMore.W2_rational_witness.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_offset". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_offset.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_radius". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_radius.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_vertex_separation". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_vertex_separation.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_offset_separation". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_offset_separation.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_half_angle". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_half_angle.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.distance_from_angle". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.distance_from_angle.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_edge_separation". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_edge_separation.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_box_bulge". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_box_bulge.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_spoke_bulge". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_spoke_bulge.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.margin_remaining_arc". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.margin_remaining_arc.
Goal True. idtac "THEOREM Confidel.lemmas.Margins.spoke_bulge_from_chord_alone". exact I. Qed. Print Assumptions Confidel.lemmas.Margins.spoke_bulge_from_chord_alone.
Goal True. idtac "THEOREM Confidel.lemmas.Pencil.pencil". exact I. Qed. Print Assumptions Confidel.lemmas.Pencil.pencil.
Goal True. idtac "THEOREM Confidel.lemmas.Pencil.pencil_converse". exact I. Qed. Print Assumptions Confidel.lemmas.Pencil.pencil_converse.
Goal True. idtac "THEOREM Confidel.lemmas.Pencil.pencil_exclusion". exact I. Qed. Print Assumptions Confidel.lemmas.Pencil.pencil_exclusion.
Goal True. idtac "THEOREM Confidel.lemmas.Pencil.gabriel". exact I. Qed. Print Assumptions Confidel.lemmas.Pencil.gabriel.
Goal True. idtac "THEOREM Confidel.lemmas.Pencil.gabriel_hull". exact I. Qed. Print Assumptions Confidel.lemmas.Pencil.gabriel_hull.
Goal True. idtac "THEOREM Confidel.lemmas.Protectors.protectors_do_not_cross". exact I. Qed. Print Assumptions Confidel.lemmas.Protectors.protectors_do_not_cross.
Goal True. idtac "THEOREM Confidel.lemmas.Protectors.repaired_protectors_do_not_cross". exact I. Qed. Print Assumptions Confidel.lemmas.Protectors.repaired_protectors_do_not_cross.
Goal True. idtac "THEOREM Confidel.lemmas.Protectors.corner_obtuse". exact I. Qed. Print Assumptions Confidel.lemmas.Protectors.corner_obtuse.
Goal True. idtac "THEOREM Confidel.lemmas.Protectors.arc_polygon_convex". exact I. Qed. Print Assumptions Confidel.lemmas.Protectors.arc_polygon_convex.
Goal True. idtac "THEOREM Confidel.lemmas.Protectors.hanging_power". exact I. Qed. Print Assumptions Confidel.lemmas.Protectors.hanging_power.
Goal True. idtac "THEOREM Confidel.lemmas.Protectors.hanging_clear". exact I. Qed. Print Assumptions Confidel.lemmas.Protectors.hanging_clear.
Goal True. idtac "THEOREM Confidel.lemmas.Protectors.hanging_end_piece". exact I. Qed. Print Assumptions Confidel.lemmas.Protectors.hanging_end_piece.
Goal True. idtac "THEOREM Confidel.lemmas.SpokeBulge.bulge_is_reach". exact I. Qed. Print Assumptions Confidel.lemmas.SpokeBulge.bulge_is_reach.
Goal True. idtac "THEOREM Confidel.lemmas.SpokeBulge.bulge_attained". exact I. Qed. Print Assumptions Confidel.lemmas.SpokeBulge.bulge_attained.
Goal True. idtac "THEOREM Confidel.lemmas.SpokeBulge.bulge_le_half_iff". exact I. Qed. Print Assumptions Confidel.lemmas.SpokeBulge.bulge_le_half_iff.
Goal True. idtac "THEOREM Confidel.lemmas.SpokeBulge.spoke_bulge_rational". exact I. Qed. Print Assumptions Confidel.lemmas.SpokeBulge.spoke_bulge_rational.
Goal True. idtac "THEOREM Confidel.lemmas.SpokeBulge.isosceles_bulge". exact I. Qed. Print Assumptions Confidel.lemmas.SpokeBulge.isosceles_bulge.
Goal True. idtac "THEOREM Confidel.lemmas.SpokeBulge.spoke_bulge". exact I. Qed. Print Assumptions Confidel.lemmas.SpokeBulge.spoke_bulge.
Goal True. idtac "THEOREM Confidel.lemmas.SpokeBulge.spoke_bulge_radius". exact I. Qed. Print Assumptions Confidel.lemmas.SpokeBulge.spoke_bulge_radius.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.T_corners". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.T_corners.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_points_outside_ball". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.T_vs_points_outside_ball.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_points_outside_ball_strict". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.T_vs_points_outside_ball_strict.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_edge_points". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.T_vs_edge_points.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_edge_points_strict". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.T_vs_edge_points_strict.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_own_edges". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.S_vs_own_edges.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_directions_outside". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.S_vs_directions_outside.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_far". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.S_vs_far.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_far_from_arc". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.S_vs_far_from_arc.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_protector". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.S_vs_protector.
Goal True. idtac "THEOREM Confidel.lemmas.VertexCells.S_reach". exact I. Qed. Print Assumptions Confidel.lemmas.VertexCells.S_reach.
Goal True. idtac "THEOREM Confidel.theorem.InFace.T_in_face". exact I. Qed. Print Assumptions Confidel.theorem.InFace.T_in_face.
Goal True. idtac "THEOREM Confidel.theorem.InFace.S_in_face". exact I. Qed. Print Assumptions Confidel.theorem.InFace.S_in_face.
Goal True. idtac "THEOREM Confidel.theorem.InFaceEdge.R_in_face". exact I. Qed. Print Assumptions Confidel.theorem.InFaceEdge.R_in_face.
Goal True. idtac "THEOREM Confidel.theorem.Legality.arc_beside_spoke". exact I. Qed. Print Assumptions Confidel.theorem.Legality.arc_beside_spoke.
Goal True. idtac "THEOREM Confidel.theorem.Legality.protector_beside_spoke". exact I. Qed. Print Assumptions Confidel.theorem.Legality.protector_beside_spoke.
Goal True. idtac "THEOREM Confidel.theorem.Legality.far_from_corner_clear". exact I. Qed. Print Assumptions Confidel.theorem.Legality.far_from_corner_clear.
Goal True. idtac "THEOREM Confidel.theorem.Legality.arc_beside_rectangle". exact I. Qed. Print Assumptions Confidel.theorem.Legality.arc_beside_rectangle.
Goal True. idtac "THEOREM Confidel.theorem.OffFaceEdge.R_off_face". exact I. Qed. Print Assumptions Confidel.theorem.OffFaceEdge.R_off_face.
Goal True. idtac "THEOREM Confidel.theorem.OffFaceEdge.C_off_face". exact I. Qed. Print Assumptions Confidel.theorem.OffFaceEdge.C_off_face.
Goal True. idtac "THEOREM Confidel.theorem.OffFaceVertex.T_off_face". exact I. Qed. Print Assumptions Confidel.theorem.OffFaceVertex.T_off_face.
Goal True. idtac "THEOREM Confidel.theorem.OffFaceVertex.S_off_face". exact I. Qed. Print Assumptions Confidel.theorem.OffFaceVertex.S_off_face.
Goal True. idtac "THEOREM Confidel.theorem.PlacedArcs.arc_points_are_placed". exact I. Qed. Print Assumptions Confidel.theorem.PlacedArcs.arc_points_are_placed.
Goal True. idtac "THEOREM Confidel.theorem.PlacedPoints.protectors_are_placed". exact I. Qed. Print Assumptions Confidel.theorem.PlacedPoints.protectors_are_placed.
Goal True. idtac "THEOREM Confidel.theorem.Setting.setting_exists". exact I. Qed. Print Assumptions Confidel.theorem.Setting.setting_exists.
Goal True. idtac "THEOREM Confidel.theorem.Theorem31.theorem_3_1_repaired". exact I. Qed. Print Assumptions Confidel.theorem.Theorem31.theorem_3_1_repaired.

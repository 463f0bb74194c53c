(* Written by check.sh: the axioms of every theorem of the trusted part. *)
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
Definition file_1 := (I, Confidel.theorem.InFace.T_in_face, Confidel.theorem.InFace.S_in_face).
Goal True.
idtac "THEOREM Confidel.theorem.InFace.T_in_face".
idtac "THEOREM Confidel.theorem.InFace.S_in_face".
exact I. Qed.
Print Assumptions file_1.
Definition file_2 := (I, Confidel.theorem.InFaceEdge.R_in_face).
Goal True.
idtac "THEOREM Confidel.theorem.InFaceEdge.R_in_face".
exact I. Qed.
Print Assumptions file_2.
Definition file_3 := (I, Confidel.theorem.Legality.arc_beside_spoke, Confidel.theorem.Legality.protector_beside_spoke, Confidel.theorem.Legality.far_from_corner_clear, Confidel.theorem.Legality.arc_beside_rectangle).
Goal True.
idtac "THEOREM Confidel.theorem.Legality.arc_beside_spoke".
idtac "THEOREM Confidel.theorem.Legality.protector_beside_spoke".
idtac "THEOREM Confidel.theorem.Legality.far_from_corner_clear".
idtac "THEOREM Confidel.theorem.Legality.arc_beside_rectangle".
exact I. Qed.
Print Assumptions file_3.
Definition file_4 := (I, Confidel.theorem.OffFaceEdge.R_off_face, Confidel.theorem.OffFaceEdge.C_off_face).
Goal True.
idtac "THEOREM Confidel.theorem.OffFaceEdge.R_off_face".
idtac "THEOREM Confidel.theorem.OffFaceEdge.C_off_face".
exact I. Qed.
Print Assumptions file_4.
Definition file_5 := (I, Confidel.theorem.OffFaceVertex.T_off_face, Confidel.theorem.OffFaceVertex.S_off_face).
Goal True.
idtac "THEOREM Confidel.theorem.OffFaceVertex.T_off_face".
idtac "THEOREM Confidel.theorem.OffFaceVertex.S_off_face".
exact I. Qed.
Print Assumptions file_5.
Definition file_6 := (I, Confidel.theorem.PlacedArcs.arc_points_are_placed).
Goal True.
idtac "THEOREM Confidel.theorem.PlacedArcs.arc_points_are_placed".
exact I. Qed.
Print Assumptions file_6.
Definition file_7 := (I, Confidel.theorem.PlacedPoints.protectors_are_placed).
Goal True.
idtac "THEOREM Confidel.theorem.PlacedPoints.protectors_are_placed".
exact I. Qed.
Print Assumptions file_7.
Definition file_8 := (I, Confidel.theorem.Setting.setting_exists).
Goal True.
idtac "THEOREM Confidel.theorem.Setting.setting_exists".
exact I. Qed.
Print Assumptions file_8.
Definition file_9 := (I, Confidel.theorem.Theorem31.theorem_3_1_repaired).
Goal True.
idtac "THEOREM Confidel.theorem.Theorem31.theorem_3_1_repaired".
exact I. Qed.
Print Assumptions file_9.
Definition file_10 := (I, Confidel.lemmas.Alignment.align_2D, Confidel.lemmas.Alignment.align_2D_any_row, Confidel.lemmas.Alignment.depth_bound, Confidel.lemmas.Alignment.depth_bound_needs_third_vertex, Confidel.lemmas.Alignment.buffer_penetration, Confidel.lemmas.Alignment.align_3D_iff, Confidel.lemmas.Alignment.aligned_ok_affine, Confidel.lemmas.Alignment.aligned_ok_rectangle, Confidel.lemmas.Alignment.aligned_ok_vector, Confidel.lemmas.Alignment.aligned_ok_equal_offsets, Confidel.lemmas.Alignment.aligned_ok_larger, Confidel.lemmas.Alignment.aligned_ok_smaller, Confidel.lemmas.Alignment.align_3D, Confidel.lemmas.Alignment.align_3D_fails_for_smaller_offset, Confidel.lemmas.Alignment.align_3D_all_centres).
Goal True.
idtac "THEOREM Confidel.lemmas.Alignment.align_2D".
idtac "THEOREM Confidel.lemmas.Alignment.align_2D_any_row".
idtac "THEOREM Confidel.lemmas.Alignment.depth_bound".
idtac "THEOREM Confidel.lemmas.Alignment.depth_bound_needs_third_vertex".
idtac "THEOREM Confidel.lemmas.Alignment.buffer_penetration".
idtac "THEOREM Confidel.lemmas.Alignment.align_3D_iff".
idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_affine".
idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_rectangle".
idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_vector".
idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_equal_offsets".
idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_larger".
idtac "THEOREM Confidel.lemmas.Alignment.aligned_ok_smaller".
idtac "THEOREM Confidel.lemmas.Alignment.align_3D".
idtac "THEOREM Confidel.lemmas.Alignment.align_3D_fails_for_smaller_offset".
idtac "THEOREM Confidel.lemmas.Alignment.align_3D_all_centres".
exact I. Qed.
Print Assumptions file_10.
Definition file_11 := (I, Confidel.lemmas.ArcSpacing.arc_subdivision, Confidel.lemmas.ArcSpacing.chord_range, Confidel.lemmas.ArcSpacing.chord_range_sqrt3, Confidel.lemmas.ArcSpacing.chord_le_half_radius, Confidel.lemmas.ArcSpacing.arc_spacing, Confidel.lemmas.ArcSpacing.arc_spacing_repaired, Confidel.lemmas.ArcSpacing.chord_range_needs_exact_h).
Goal True.
idtac "THEOREM Confidel.lemmas.ArcSpacing.arc_subdivision".
idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_range".
idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_range_sqrt3".
idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_le_half_radius".
idtac "THEOREM Confidel.lemmas.ArcSpacing.arc_spacing".
idtac "THEOREM Confidel.lemmas.ArcSpacing.arc_spacing_repaired".
idtac "THEOREM Confidel.lemmas.ArcSpacing.chord_range_needs_exact_h".
exact I. Qed.
Print Assumptions file_11.
Definition file_12 := (I, Confidel.lemmas.BoxBulge.box_bulge_is_reach, Confidel.lemmas.BoxBulge.box_bulge_le_half, Confidel.lemmas.BoxBulge.box_bulge_rational, Confidel.lemmas.BoxBulge.box_bulge_own_subdivision).
Goal True.
idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_is_reach".
idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_le_half".
idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_rational".
idtac "THEOREM Confidel.lemmas.BoxBulge.box_bulge_own_subdivision".
exact I. Qed.
Print Assumptions file_12.
Definition file_13 := (I, Confidel.lemmas.ChewClearance.segment_clearance, Confidel.lemmas.ChewClearance.segment_clearance_closed, Confidel.lemmas.ChewClearance.chew_clearance, Confidel.lemmas.ChewClearance.chew_clearance_own_subdivision).
Goal True.
idtac "THEOREM Confidel.lemmas.ChewClearance.segment_clearance".
idtac "THEOREM Confidel.lemmas.ChewClearance.segment_clearance_closed".
idtac "THEOREM Confidel.lemmas.ChewClearance.chew_clearance".
idtac "THEOREM Confidel.lemmas.ChewClearance.chew_clearance_own_subdivision".
exact I. Qed.
Print Assumptions file_13.
Definition file_14 := (I, Confidel.lemmas.ChewLemma.segment_does_not_separate, Confidel.lemmas.ChewLemma.chew_clean, Confidel.lemmas.ChewLemma.chew_clean_far_from_vertices).
Goal True.
idtac "THEOREM Confidel.lemmas.ChewLemma.segment_does_not_separate".
idtac "THEOREM Confidel.lemmas.ChewLemma.chew_clean".
idtac "THEOREM Confidel.lemmas.ChewLemma.chew_clean_far_from_vertices".
exact I. Qed.
Print Assumptions file_14.
Definition file_15 := (I, Confidel.lemmas.DihedralGap.dihedral_gap_general, Confidel.lemmas.DihedralGap.dihedral_gap, Confidel.lemmas.DihedralGap.dihedral_gap_attained, Confidel.lemmas.DihedralGap.dihedral_gap_rational).
Goal True.
idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap_general".
idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap".
idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap_attained".
idtac "THEOREM Confidel.lemmas.DihedralGap.dihedral_gap_rational".
exact I. Qed.
Print Assumptions file_15.
Definition file_16 := (I, Confidel.lemmas.EdgeCells.R_corners, Confidel.lemmas.EdgeCells.R_alignment_iff, Confidel.lemmas.EdgeCells.R_vs_aligned, Confidel.lemmas.EdgeCells.offset_passes, Confidel.lemmas.EdgeCells.R_vs_other_face, Confidel.lemmas.EdgeCells.R_vs_own_face, Confidel.lemmas.EdgeCells.R_vs_far, Confidel.lemmas.EdgeCells.R_vs_directions).
Goal True.
idtac "THEOREM Confidel.lemmas.EdgeCells.R_corners".
idtac "THEOREM Confidel.lemmas.EdgeCells.R_alignment_iff".
idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_aligned".
idtac "THEOREM Confidel.lemmas.EdgeCells.offset_passes".
idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_other_face".
idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_own_face".
idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_far".
idtac "THEOREM Confidel.lemmas.EdgeCells.R_vs_directions".
exact I. Qed.
Print Assumptions file_16.
Definition file_17 := (I, Confidel.lemmas.EdgeFaceAngle.spoke_centre_correct, Confidel.lemmas.EdgeFaceAngle.edge_face_criterion, Confidel.lemmas.EdgeFaceAngle.prop_G, Confidel.lemmas.EdgeFaceAngle.tilt_from_dihedral, Confidel.lemmas.EdgeFaceAngle.edge_face_clear, Confidel.lemmas.EdgeFaceAngle.edge_face_clear_strict).
Goal True.
idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.spoke_centre_correct".
idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.edge_face_criterion".
idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.prop_G".
idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.tilt_from_dihedral".
idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.edge_face_clear".
idtac "THEOREM Confidel.lemmas.EdgeFaceAngle.edge_face_clear_strict".
exact I. Qed.
Print Assumptions file_17.
Definition file_18 := (I, Confidel.lemmas.EdgeSpacing.edge_spacing, Confidel.lemmas.EdgeSpacing.edge_spacing_sqrt3, Confidel.lemmas.EdgeSpacing.edge_has_two_intervals, Confidel.lemmas.EdgeSpacing.aligned_row_spacing, Confidel.lemmas.EdgeSpacing.aligned_cell_is_rectangle).
Goal True.
idtac "THEOREM Confidel.lemmas.EdgeSpacing.edge_spacing".
idtac "THEOREM Confidel.lemmas.EdgeSpacing.edge_spacing_sqrt3".
idtac "THEOREM Confidel.lemmas.EdgeSpacing.edge_has_two_intervals".
idtac "THEOREM Confidel.lemmas.EdgeSpacing.aligned_row_spacing".
idtac "THEOREM Confidel.lemmas.EdgeSpacing.aligned_cell_is_rectangle".
exact I. Qed.
Print Assumptions file_18.
Definition file_19 := (I, Confidel.lemmas.FaceCells.C_vs_far, Confidel.lemmas.FaceCells.C_vs_vertex, Confidel.lemmas.FaceCells.C_vs_other_face).
Goal True.
idtac "THEOREM Confidel.lemmas.FaceCells.C_vs_far".
idtac "THEOREM Confidel.lemmas.FaceCells.C_vs_vertex".
idtac "THEOREM Confidel.lemmas.FaceCells.C_vs_other_face".
exact I. Qed.
Print Assumptions file_19.
Definition file_20 := (I, Confidel.lemmas.LiteralRule.W3_phi, Confidel.lemmas.LiteralRule.W3_literal_rule_fails, Confidel.lemmas.LiteralRule.W3_phi_third, Confidel.lemmas.LiteralRule.W3_phi_quarter, Confidel.lemmas.LiteralRule.G3_phi).
Goal True.
idtac "THEOREM Confidel.lemmas.LiteralRule.W3_phi".
idtac "THEOREM Confidel.lemmas.LiteralRule.W3_literal_rule_fails".
idtac "THEOREM Confidel.lemmas.LiteralRule.W3_phi_third".
idtac "THEOREM Confidel.lemmas.LiteralRule.W3_phi_quarter".
idtac "THEOREM Confidel.lemmas.LiteralRule.G3_phi".
exact I. Qed.
Print Assumptions file_20.
Definition file_21 := (I, Confidel.lemmas.LiteralRuleMore.literal_2D_protectors_cross, Confidel.lemmas.LiteralRuleMore.repaired_2D_protectors, Confidel.lemmas.LiteralRuleMore.W2_phi, Confidel.lemmas.LiteralRuleMore.W2_diametral_spheres_fail, Confidel.lemmas.LiteralRuleMore.W2_rational_witness).
Goal True.
idtac "THEOREM Confidel.lemmas.LiteralRuleMore.literal_2D_protectors_cross".
idtac "THEOREM Confidel.lemmas.LiteralRuleMore.repaired_2D_protectors".
idtac "THEOREM Confidel.lemmas.LiteralRuleMore.W2_phi".
idtac "THEOREM Confidel.lemmas.LiteralRuleMore.W2_diametral_spheres_fail".
idtac "THEOREM Confidel.lemmas.LiteralRuleMore.W2_rational_witness".
exact I. Qed.
Print Assumptions file_21.
Definition file_22 := (I, Confidel.lemmas.Margins.margin_offset, Confidel.lemmas.Margins.margin_radius, Confidel.lemmas.Margins.margin_vertex_separation, Confidel.lemmas.Margins.margin_offset_separation, Confidel.lemmas.Margins.margin_half_angle, Confidel.lemmas.Margins.distance_from_angle, Confidel.lemmas.Margins.margin_edge_separation, Confidel.lemmas.Margins.margin_box_bulge, Confidel.lemmas.Margins.margin_spoke_bulge, Confidel.lemmas.Margins.margin_remaining_arc, Confidel.lemmas.Margins.spoke_bulge_from_chord_alone).
Goal True.
idtac "THEOREM Confidel.lemmas.Margins.margin_offset".
idtac "THEOREM Confidel.lemmas.Margins.margin_radius".
idtac "THEOREM Confidel.lemmas.Margins.margin_vertex_separation".
idtac "THEOREM Confidel.lemmas.Margins.margin_offset_separation".
idtac "THEOREM Confidel.lemmas.Margins.margin_half_angle".
idtac "THEOREM Confidel.lemmas.Margins.distance_from_angle".
idtac "THEOREM Confidel.lemmas.Margins.margin_edge_separation".
idtac "THEOREM Confidel.lemmas.Margins.margin_box_bulge".
idtac "THEOREM Confidel.lemmas.Margins.margin_spoke_bulge".
idtac "THEOREM Confidel.lemmas.Margins.margin_remaining_arc".
idtac "THEOREM Confidel.lemmas.Margins.spoke_bulge_from_chord_alone".
exact I. Qed.
Print Assumptions file_22.
Definition file_23 := (I, Confidel.lemmas.Pencil.pencil, Confidel.lemmas.Pencil.pencil_converse, Confidel.lemmas.Pencil.pencil_exclusion, Confidel.lemmas.Pencil.gabriel, Confidel.lemmas.Pencil.gabriel_hull).
Goal True.
idtac "THEOREM Confidel.lemmas.Pencil.pencil".
idtac "THEOREM Confidel.lemmas.Pencil.pencil_converse".
idtac "THEOREM Confidel.lemmas.Pencil.pencil_exclusion".
idtac "THEOREM Confidel.lemmas.Pencil.gabriel".
idtac "THEOREM Confidel.lemmas.Pencil.gabriel_hull".
exact I. Qed.
Print Assumptions file_23.
Definition file_24 := (I, Confidel.lemmas.Protectors.protectors_do_not_cross, Confidel.lemmas.Protectors.repaired_protectors_do_not_cross, Confidel.lemmas.Protectors.corner_obtuse, Confidel.lemmas.Protectors.arc_polygon_convex, Confidel.lemmas.Protectors.hanging_power, Confidel.lemmas.Protectors.hanging_clear, Confidel.lemmas.Protectors.hanging_end_piece).
Goal True.
idtac "THEOREM Confidel.lemmas.Protectors.protectors_do_not_cross".
idtac "THEOREM Confidel.lemmas.Protectors.repaired_protectors_do_not_cross".
idtac "THEOREM Confidel.lemmas.Protectors.corner_obtuse".
idtac "THEOREM Confidel.lemmas.Protectors.arc_polygon_convex".
idtac "THEOREM Confidel.lemmas.Protectors.hanging_power".
idtac "THEOREM Confidel.lemmas.Protectors.hanging_clear".
idtac "THEOREM Confidel.lemmas.Protectors.hanging_end_piece".
exact I. Qed.
Print Assumptions file_24.
Definition file_25 := (I, Confidel.lemmas.SpokeBulge.bulge_is_reach, Confidel.lemmas.SpokeBulge.bulge_attained, Confidel.lemmas.SpokeBulge.bulge_le_half_iff, Confidel.lemmas.SpokeBulge.spoke_bulge_rational, Confidel.lemmas.SpokeBulge.isosceles_bulge, Confidel.lemmas.SpokeBulge.spoke_bulge, Confidel.lemmas.SpokeBulge.spoke_bulge_radius).
Goal True.
idtac "THEOREM Confidel.lemmas.SpokeBulge.bulge_is_reach".
idtac "THEOREM Confidel.lemmas.SpokeBulge.bulge_attained".
idtac "THEOREM Confidel.lemmas.SpokeBulge.bulge_le_half_iff".
idtac "THEOREM Confidel.lemmas.SpokeBulge.spoke_bulge_rational".
idtac "THEOREM Confidel.lemmas.SpokeBulge.isosceles_bulge".
idtac "THEOREM Confidel.lemmas.SpokeBulge.spoke_bulge".
idtac "THEOREM Confidel.lemmas.SpokeBulge.spoke_bulge_radius".
exact I. Qed.
Print Assumptions file_25.
Definition file_26 := (I, Confidel.lemmas.VertexCells.T_corners, Confidel.lemmas.VertexCells.T_vs_points_outside_ball, Confidel.lemmas.VertexCells.T_vs_points_outside_ball_strict, Confidel.lemmas.VertexCells.T_vs_edge_points, Confidel.lemmas.VertexCells.T_vs_edge_points_strict, Confidel.lemmas.VertexCells.S_vs_own_edges, Confidel.lemmas.VertexCells.S_vs_directions_outside, Confidel.lemmas.VertexCells.S_vs_far, Confidel.lemmas.VertexCells.S_vs_far_from_arc, Confidel.lemmas.VertexCells.S_vs_protector, Confidel.lemmas.VertexCells.S_reach).
Goal True.
idtac "THEOREM Confidel.lemmas.VertexCells.T_corners".
idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_points_outside_ball".
idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_points_outside_ball_strict".
idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_edge_points".
idtac "THEOREM Confidel.lemmas.VertexCells.T_vs_edge_points_strict".
idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_own_edges".
idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_directions_outside".
idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_far".
idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_far_from_arc".
idtac "THEOREM Confidel.lemmas.VertexCells.S_vs_protector".
idtac "THEOREM Confidel.lemmas.VertexCells.S_reach".
exact I. Qed.
Print Assumptions file_26.

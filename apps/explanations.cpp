// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/explanations.h"

#include <algorithm>
#include <cctype>

namespace confidel {
namespace {

constexpr Explanation table[] = {
    {"E-USAGE", "error", "The command line is not understood: an unknown option, a missing or superfluous argument, a value out of range.",
     "See `confidel COMMAND --help`."},
    {"E-FILE", "error", "A file cannot be opened, read, or written. Exit code 4. Nothing half-written is left behind.",
     "Check the path, its permissions, and the space left on the device."},
    {"E-INTERNAL", "error", "The program is at fault, whatever the input: memory ran out, or its own checker did not accept what it wrote. Exit code 70.",
     "Report it with the input file and the command line."},
    {"E-FORMAT", "error", "The suffix names no format that is read or written here, or the file is a variant of its format that is not (binary .off, strips in .ply).",
     "Write the file in another format; docs/formats.md lists them."},
    {"E-SYNTAX", "error", "A word or character stands where another is expected. In a certificate: any spelling that is not the only one that the format allows.",
     "Look at the line and column; docs/formats.md has the grammar of each format, docs/certificate-format.md that of certificates."},
    {"E-FIELDS", "error",
     "A record has too few or too many fields; the column is where the first is missing or superfluous. Nothing is assumed to be 0: a short row would shift everything behind it.",
     "Complete the row, or correct the counts in the header (attributes and markers are announced there)."},
    {"E-NUMBER", "error",
     "A field is not a number, is not finite, or does not fit: beyond the largest double, not zero but rounding to zero, or an integer beyond 32 bits. Hexadecimal and octal are not read.",
     "Correct the number, or scale the input."},
    {"E-VALUE", "error", "A number is outside the few values that its field can have: a dimension, a number of markers, the corners of a polygon, the weight of a certificate's point.",
     "Correct the header or the record at the place that is named."},
    {"E-COUNT", "error", "A count is negative, too large to be true, or differs from the number of records that follow.", "Correct the count, or restore the missing records."},
    {"E-INDEX", "error", "A vertex is referred to that does not exist, or the rows of a file are not numbered one by one from 0 or 1.",
     "Check whether the file counts from 0 or from 1: the number of its first vertex decides."},
    {"E-RANGE", "error", "A certificate refers to a vertex, segment, facet or point that does not exist.", "The certificate is damaged: make it again."},
    {"E-ORDER", "error", "Records of a certificate that must be strictly sorted are not. Every complex has one spelling only.", "The certificate is damaged, or its writer is wrong."},
    {"E-TRUNCATED", "error", "The file ends where more is expected.", "Restore the rest of the file, or correct the counts."},
    {"E-TRAILING", "error", "Something stands behind the end of the file's last section.", "Remove it, or correct the counts."},
    {"E-EMPTY", "error", "There are no vertices, or nothing but vertices: there is nothing to conform to.", "Check that this is the right file, and that it holds a surface or segments."},
    {"E-ZSTD", "error", "The zstd frame of a certificate is damaged, or more than one frame or other bytes stand in the file.", "Restore the file, or decompress it with `zstd -d` to see how far it goes."},
    {"E-TOO-LARGE", "error", "A picture of so many cells would not open in a browser.", "Write .vtu and look at it in ParaView."},
    {"E-COVER", "error", "The records of a campaign are not what its plan says: blocks are missing, changed, overlap, or come from other programs.", "Run the campaign again; complete blocks are kept."},
    {"E-DUPLICATE-VERTEX", "error", "Two vertices have exactly the same position. Which of them a facet means would matter to the facet's neighbours.",
     "Keep one of them, or say `--merge-identical`. Nothing that is merely close is ever merged."},
    {"E-DEGENERATE-FACET", "error", "A facet has no area: its corners lie on one line, it has fewer than three different ones, or its loops enclose nothing.",
     "Remove the facet, or correct its corners."},
    {"E-NONCOPLANAR", "error",
     "A facet's corners do not lie in one plane, exactly. The message says which corner is off the plane and by how much of the facet's size; 1e-16 is as wrong as 0.1, since a Delaunay face is flat.",
     "Correct the coordinates, or cut such facets into triangles: `confidel convert IN OUT --facets triangulate`."},
    {"E-CROSSING", "error", "Two segments, two facets, or a segment and a facet meet in a point or line that is no vertex or segment of both. No triangulation contains both.",
     "Make the crossing a vertex or segment of both, or remove one. In the plane, `confidel convert IN OUT --split-crossings` does it; it may have to move the new point to a double."},
    {"E-OVERLAP", "error", "Two facets of one plane have an area in common.", "Remove one of them if they are the same; otherwise cut them so that they share only edges."},
    {"E-OPEN-LOOP", "error", "The segments of a facet close no loop: it has no area.", "Close the loop, or give the segments by themselves."},
    {"E-HOLE", "error", "A hole point lies exactly on an edge, or the hole points remove everything: it is unclear what the facet is.",
     "Move the point strictly inside the hole, and close the hole's loop."},

    {"hash", "rule", "The digest at the end of the certificate is that of its text.", "The certificate was changed after it had been written."},
    {"complex", "rule", "The complex in the certificate is well formed, and is, byte for byte, the one given by `--complex`.",
     "Compare with `confidel canonical FILE`: the certificate may be about another input."},
    {"distinct", "rule", "All points, vertices and Steiner points, are distinct.", ""},
    {"carrier", "rule", "Each Steiner point lies exactly on its segment or in its facet's plane, and is used by a cell of its facet.", ""},
    {"cell", "rule", "Each cell is a triangle of positive orientation in its facet, with corners that belong there.", ""},
    {"box", "rule", "The two triangles of a rectangle of edge protection form a rectangle, exactly.", ""},
    {"kinds", "rule", "Where lemmas are claimed, each cell is what its letter says: T at an edge's end, S between a vertex and its arc, R half of a rectangle, C the rest; and its sphere is the smallest one.", ""},
    {"tiling", "rule", "The cells of each facet cover it exactly once and contain its inner constraints and isolated vertices.", ""},
    {"emptiness", "rule", "Each cell has a sphere through its corners with no point inside, and no point on it off the facet's plane.", ""},
    {"tie", "rule", "Where points lie on a cell's circle, in its plane, they are not beyond a constrained edge: every choice among equals conforms.", ""},
    {"hanging", "rule", "Segments in no facet are chains of subsegments whose diametral balls hold no other point, on the boundary either.", ""},
    {"rows", "rule", "The points beside a protected edge are copies of the edge's points, moved by one vector orthogonal to it.", ""},

    {"max-points", "reason", "More points would be needed than `--max-points` allows.", "Raise the limit, or 0 for none; `estimate=` says what to expect. The lean strategy needs fewer points than graded."},
    {"time-limit", "reason", "The time of `--time-limit` is over.", "Raise the limit."},
    {"memory-limit", "reason", "The memory of `--memory-limit` is used up.", "Raise the limit."},
    {"range", "reason", "A size that an input's distances and angles ask for is below 2^-240 of its extent: sizes are steered in doubles, which end there.", "Snap the input to a grid; or `--strategy lean`, which often needs no sizes."},
    {"too-large", "reason", "The checker declines: an integer, a count, a line or a zstd window exceeds what the format allows.", "docs/certificate-format.md section 1 has the limits."},
    {"cells", "reason", "What ranges over cells was tested for those of `--cells` only.", "Test the others too, or without that option."},
    {"newer-version", "reason", "The certificate is of a version that this checker does not know.", "Use a newer checker."},
    {"strategy-failed", "reason", "A strategy found that it cannot go on with this input; it never answers wrongly instead.", "Try the other strategy: `--strategy graded` or `--strategy lean`."},
    {"algebraic-degree", "reason", "`lemma --kernel algebraic`: a sign needs more independent square roots than are decided.", "Give the input simpler coordinates, or test the rational points: `confidel lemma check all CERTIFICATE`."},
    {"no-certificate", "reason", "Of a mesh under audit nothing fails, but a segment outside of all facets has a point in the smallest ball of a piece: certificates of this version cannot say that it is an edge nevertheless.", "Split that piece."},

    {"H-angle", "claim", "The angle that the parameters are made from is at most every angle of the complex that counts (docs/lemma-claims.md, section 4).", ""},
    {"H-ball", "claim", "The corners of cells at a vertex lie at the protecting radius from it, as the parameters say.", ""},
    {"H-offset", "claim", "Protectors lie no farther from their edges than the parameters allow.", ""},
    {"H-chord", "claim", "The spacing h is at most the chord that the parameters allow.", ""},

    {"L0a", "lemma", "an edge with a ball through its ends and no point in it is an edge of the Delaunay subdivision; of every one if no tie separates its ends", ""},
    {"L0b", "lemma", "a triangle with a sphere through its corners and no point in it is a union of faces of the Delaunay subdivision; all such spheres form a pencil", ""},
    {"L1", "lemma", "neighbours on an arc are between h and 3h/2 apart (the paper: sqrt3 h)", ""},
    {"L2", "lemma", "neighbours on edges and protectors are between h and 3h/2 apart; rows are aligned: protector = row + one vector", ""},
    {"L3", "lemma", "the circle of a spoke triangle bulges at most h/2 beyond its chord", ""},
    {"L4", "lemma", "the circle of a rectangle bulges at most h/2 beyond the buffer", ""},
    {"L5", "lemma", "protectors of neighbouring edges do not cross (at the paper's largest d they do)", ""},
    {"L6", "lemma", "points of the boundary of P'' are at least h apart", ""},
    {"L7", "lemma", "corners of P'' are obtuse", ""},
    {"L8", "lemma", "where R > h the circumcentre lies in P'', farther than h from points and h/2 from the boundary", ""},
    {"L9", "lemma", "T's sphere is empty", ""},
    {"L10", "lemma", "S's sphere does not contain the cap points of other edges (false with the paper's parameters)", ""},
    {"L11", "lemma", "S against arcs, protectors and inner points", ""},
    {"L12", "lemma", "R against the aligned points of other faces at its edge: o'.(o'-o) > 0", ""},
    {"L13", "lemma", "R against everything else", ""},
    {"L14", "lemma", "outside their buffers, faces at an edge are at least 2d sin(alpha/2) apart", ""},
    {"L15", "lemma", "edges at a vertex make at least the angle phi* with faces that do not contain them", ""},
    {"L16", "lemma", "C's sphere is empty, R <= h", ""},
    {"L17", "lemma", "boundary(P'') is locally Delaunay in its plane", ""},
    {"L18", "lemma", "every cell has a sphere without points in it, and without points on it off its plane", ""},
    {"L18b", "lemma", "a point in the plane and on a cell's circle is not beyond an edge of the cell that lies on a segment", ""},
    {"L19", "lemma", "the cells tile the facet exactly, inner constraints are unions of their edges", ""},
    {"L20", "lemma", "circumradii in the plane are bounded by r_max", ""},
    {"L21", "lemma", "simplices without common vertex are at least 3r apart", ""},
    {"L22", "lemma", "the closed diametral ball of each piece of a hanging edge contains no other point", ""},
    {"L23", "lemma", "circles of P'' penetrate the buffer by at most 3h/2", ""},
    {"LG", "lemma", "with the paper's own parameters W3, G3 and W2 fail", ""},
};

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::span<const Explanation> explanations() { return table; }

const Explanation* find_explanation(std::string_view name) {
  const auto found = std::find_if(std::begin(table), std::end(table), [&](const Explanation& each) { return same_name(each.name, name); });
  return found == std::end(table) ? nullptr : &*found;
}

}  // namespace confidel

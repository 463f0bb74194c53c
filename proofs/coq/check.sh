#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The trusted part of proofs/coq, checked: builds, runs coqchk, refuses statements
# without proof, prints the axioms of every theorem into docs/proofs.md.
# Exit codes: 0 all is proved, 1 something is not, 4 a tool or file is missing.
#   ./check.sh          our modules by coqchk, the standard library as installed
#   ./check.sh --full   coqchk rechecks the standard library too (minutes)
#   ./check.sh --only lemmas theorem    restrict to these folders
set -u
cd "$(dirname "$0")" || exit 4
full=no; folders="lemmas theorem checker"
while [ $# -gt 0 ]; do
  case "$1" in
    --full) full=yes; shift ;;
    --only) shift; folders="$*"; break ;;
    *) echo "usage: check.sh [--full] [--only FOLDER...]" >&2; exit 2 ;;
  esac
done
for tool in coqc coqchk coqdep perl make; do
  command -v $tool >/dev/null || { echo "check.sh: $tool not found" >&2; exit 4; }
done
fail() { echo "check.sh: FAILED: $*" >&2; exit 1; }
work=.check; mkdir -p $work

files=""; maps=""
for f in $folders; do
  [ -d "$f" ] || continue
  maps="$maps -Q $f Confidel.$f"
  files="$files $(find "$f" -name '*.v' ! -path 'theorem/Remaining.v' | sort)"
done

# 1. Statements without proof, outside comments. Before the build: it is the cheapest test.
bad=0
for v in $files; do
  perl -0777 -ne '
    s/"(?:[^"]|"")*"/""/g;
    1 while s/\(\*(?:(?!\(\*|\*\)).)*\*\)/ /gs;           # nested comments, innermost first
    while (/\b(Admitted|admit|give_up|Abort|Aborted)\b|(?:^|\.)\s*(?:Local\s+|Global\s+|#\[[^\]]*\]\s*)*(Axioms?|Parameters?|Conjectures?|Declare\s+Module|Unset\s+(?:Guard|Positivity|Universe)\s+Checking|Set\s+Type\s+In\s+Type|Bypass)\b/g) {
      print "$ARGV: ", (defined $1 ? $1 : $2), "\n"; $n++ }
    END { exit($n ? 1 : 0) }' "$v" || bad=1
done
[ $bad -eq 0 ] || fail "statements without proof in the trusted part"

# 2. Build.
targets=""; for v in $files; do targets="$targets ${v%.v}.vo"; done
make -j1 $targets >$work/build.log 2>&1 || { tail -20 $work/build.log >&2; fail "build (proofs/coq/.check/build.log)"; }

# 3. The independent kernel.
modules=""
for v in $files; do modules="$modules Confidel.$(echo "${v%.v}" | tr / .)"; done
if [ $full = yes ]; then
  coqchk -silent -o $maps $modules >$work/coqchk.log 2>&1 || { tail -20 $work/coqchk.log >&2; fail "coqchk"; }
else
  norec=""; for m in $modules; do norec="$norec -norec $m"; done
  coqchk -silent $maps $norec >$work/coqchk.log 2>&1 || { tail -20 $work/coqchk.log >&2; fail "coqchk"; }
fi

# 4. Axioms of the theorems and corollaries, per file.
{
  echo "(* Written by check.sh: the axioms of every theorem of the trusted part. *)"
  n=0
  for v in $files; do echo "Require Confidel.$(echo "${v%.v}" | tr / .)."; done
  for v in $files; do
    m=Confidel.$(echo "${v%.v}" | tr / .)
    ts=$(sed -nE 's/^(Theorem|Corollary) ([A-Za-z0-9_'"'"']+).*/\2/p' "$v")
    [ -n "$ts" ] || continue
    # one file, one question: Print Assumptions walks the Reals anew every time
    n=$((n + 1)); all=I; for t in $ts; do all="$all, $m.$t"; done
    echo "Definition file_$n := ($all)."
    echo "Goal True."; for t in $ts; do echo "idtac \"THEOREM $m.$t\"."; done; echo "exact I. Qed."
    echo "Print Assumptions file_$n."
  done
} > $work/Assumptions.v
coqc -q -w none $maps $work/Assumptions.v >$work/assumptions.log 2>&1 || { tail -20 $work/assumptions.log >&2; fail "Print Assumptions"; }

perl -ne '
  BEGIN { %ok = map { $_ => 1 } qw(
    ClassicalDedekindReals.sig_forall_dec ClassicalDedekindReals.sig_not_dec
    FunctionalExtensionality.functional_extensionality_dep Classical_Prop.classic); $bad = 0 }
  if (/^THEOREM Confidel\.(\S+)\.([^.\s]+)\s*$/) { push @order, [$1, $2];
    @group = () if $closed; $closed = 0; push @group, "$1.$2"; next }
  next unless @group;
  if (/^([A-Za-z_][\w.\x27]*)\s*(:|$)/ && $1 ne "Axioms" && !/^Closed under/) {
    push @{$ax{$_}}, $1 for @group;
    unless ($ok{$1}) { print STDERR "axiom outside the allow-list: $1 in one of @group\n"; $bad = 1 }
  }
  $closed = 1;
  END {
    print STDERR "no theorem found\n" and exit 1 unless @order;
    my %short = ("ClassicalDedekindReals.sig_forall_dec" => "F", "ClassicalDedekindReals.sig_not_dec" => "N",
      "FunctionalExtensionality.functional_extensionality_dep" => "E", "Classical_Prop.classic" => "C");
    print "| file | theorems | axioms |\n|---|---|---|\n"; my (%row, @rows);
    for (@order) { my ($f, $n) = @$_;
      my $a = join " ", sort map { $short{$_} // $_ } @{$ax{"$f.$n"} // []}; $a = "none" if $a eq "";
      my $k = "$f\t$a"; push @rows, $k unless $row{$k}; push @{$row{$k}}, $n }
    for (@rows) { my ($f, $a) = split /\t/; (my $p = $f) =~ tr|.|/|;
      print "| $p.v | ", join(", ", @{$row{$_}}), " | $a |\n" }
    exit $bad }' $work/assumptions.log > $work/table.md || fail "axioms"

# 5. The table in docs/proofs.md, between its markers; rows of folders not checked now stay.
doc=../../docs/proofs.md
if [ -f $doc ]; then
  grep -q '<!-- assumptions begin -->' $doc && grep -q '<!-- assumptions end -->' $doc || fail "markers missing in docs/proofs.md"
  perl -e '
    my ($doc, $table, %now) = (shift, shift, map { $_ => 1 } @ARGV);
    local $/; open my $d, "<", $doc; my $t = <$d>; open my $n, "<", $table; my $new = <$n>;
    $t =~ s{(<!-- assumptions begin -->\n)(.*?)(<!-- assumptions end -->)}{
      my ($b, $old, $e) = ($1, $2, $3);
      my %rows;
      for (split(/^/, $new), grep { m{^\| (\w+)/} && !$now{$1} } split(/^/, $old)) { push @{$rows{m{^\| (\w+)/} ? $1 : ""}}, $_ }
      $b . join("", map { @{$rows{$_} || []} } "", "lemmas", "theorem", "checker") . $e }es;
    print $t' $doc $work/table.md $folders > $work/proofs.md || fail "docs/proofs.md"
  cmp -s $work/proofs.md $doc || cat $work/proofs.md > $doc
fi
echo "check.sh: $(grep -c THEOREM $work/assumptions.log) theorems, no statement without proof, axioms within the allow-list"

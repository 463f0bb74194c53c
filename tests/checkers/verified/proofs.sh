#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# No gaps in the proofs of the verified checker: no Admitted, no axiom of our own, the independent kernel agrees, and the theorems rest on
# the axioms of Coq's real numbers only.    proofs.sh [--no-coqchk]
here=$(cd "$(dirname "$0")" && pwd)
proofs=$(cd "$here/../../../proofs/coq/checker" && pwd)
make -s -C "$proofs" proofs || exit 1
found=$(make -s -C "$proofs" axioms) || { echo "$found"; echo "FAIL: a gap or an axiom in the sources"; exit 1; }
echo "$found"
grep -q 'sig_forall_dec' <<<"$found" || { echo "FAIL: no axioms printed"; exit 1; }
others=$(grep -E '^[A-Za-z_][A-Za-z0-9_.]*( :|$)' <<<"$found" | grep -vE '^(Axioms:|ClassicalDedekindReals\.sig_forall_dec|FunctionalExtensionality\.functional_extensionality_dep)' )
[ -z "$others" ] || { echo "FAIL: other axioms: $others"; exit 1; }
[ "$1" = --no-coqchk ] || { make -s -C "$proofs" coqchk && echo "coqchk agrees"; }

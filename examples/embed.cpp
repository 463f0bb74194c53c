// SPDX-License-Identifier: GPL-3.0-or-later
// Confidel in a program of one's own: embed INPUT CERTIFICATE. tests/install builds it against an installation.
#include <confidel/proofs/api/confidel.h>

#include <iostream>

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const confidel::Complex complex = confidel::build_complex(confidel::read_input(arguments[1])).complex;
  confidel::ConformingRequest request;
  request.certificate = arguments[2];
  const confidel::ConformingResult result = confidel::make_conforming(complex, request);
  std::cout << result.placement.points.size() - complex.vertices.size() << " Steiner points, " << result.placement.cells.size() << " cells\n";
  const confidel::CheckerRun checker = confidel::check_certificate(request.certificate, complex);
  std::cout << checker.verdict << "\n";
  return checker.exit_code;
}

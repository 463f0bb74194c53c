// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "certificate.h"
#include "text.h"

std::uint32_t readCount(Text&);
void readLiteral(Text&, std::string_view keyword, std::string_view value, std::initializer_list<std::string_view> miscounted = {});
void readCoordinates(Text&, int dimension, IntegerStore&);
void readComplex(Text&, Certificate&, const std::string& complexPath);
void readClaims(Text&, Claims&);           // from the line `claims` on
void readParameters(Text&, Certificate&);  // from the line `parameters` on
void readEvidence(Text&, Certificate&);    // from the line `evidence` on

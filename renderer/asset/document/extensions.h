#pragma once
#include <string>
#include <vector>

#include "asset/check/warnings.h"

namespace telar::asset {

/// @param tolerant W_EXT_REQUIRED in place of the error
/// @throws Error{E_EXT_REQUIRED} that names the first required extension that telar does not have.
void checkExtensions(const std::vector<std::string>& used, const std::vector<std::string>& required, Warnings& warnings,
                     bool tolerant = false);

}  // namespace telar::asset

#pragma once
#include <draco/point_cloud/point_cloud.h>

#include <memory>
#include <span>
#include <string>

#include "asset/accessor/draco_mesh.h"

namespace telar::asset {

/// Runs libdraco over data whose header was read.
/// @param loan for connectivity and common attributes; it grows to what the declared attributes take, where that is more
/// @return a draco::Mesh, unless it is points alone
/// @throws Error{E_DRACO, L_MEMORY_BYTES, X_CANCELLED}; cancelling acts between connectivity and each group of attributes
std::unique_ptr<draco::PointCloud> decodeDraco(std::span<const std::byte> data, const DracoCounts& counts,
                                               MemoryBudget::Loan& loan, const CancelToken& cancel,
                                               const std::string& where);

}  // namespace telar::asset

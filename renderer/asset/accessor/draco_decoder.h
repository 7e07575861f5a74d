#pragma once
#include <draco/point_cloud/point_cloud.h>

#include <memory>
#include <span>
#include <string>

#include "asset/accessor/draco_mesh.h"

namespace telar::asset {

/// What decoding may take.
struct DracoMemory {
  std::uint64_t lent;        ///< bytes that are lent for already, connectivity and common attributes
  MemoryBudget::Loan& loan;  ///< grows by what the attributes that the data declares take beyond that
};

/// Runs libdraco over data whose header was read.
/// @return a draco::Mesh, unless it is points alone
/// @throws Error{E_DRACO, L_MEMORY_BYTES, X_CANCELLED}; cancelling acts between connectivity and each group of attributes
std::unique_ptr<draco::PointCloud> decodeDraco(std::span<const std::byte> data, const DracoCounts& counts,
                                               DracoMemory memory, const CancelToken& cancel, const std::string& where);

}  // namespace telar::asset

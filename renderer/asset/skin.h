#pragma once
#include "asset/accessor.h"

namespace telar::asset {

/// Skins are not applied (W_SKIN), but one that contradicts its mesh makes the file wrong.
/// @throws Error{E_SKIN} where joints of the mesh or the inverse bind matrices do not match the skin
void checkSkin(int skin, int mesh, const Document& document, const Accessors& accessors, const CancelToken& cancel);

}  // namespace telar::asset

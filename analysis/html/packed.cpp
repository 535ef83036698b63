// SPDX-License-Identifier: MIT
#include "analysis/html/packed.h"

#include <fmt/format.h>
#include <zlib.h>

#include "analysis/html/markup.h"
#include "simulator/base/error.h"

namespace lanescope {

std::string packed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string compressed(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  LANESCOPE_CHECK(status == Z_OK, "zlib returned {}", status);
  compressed.resize(size);
  return base64(compressed);
}

std::string packed_script(const nlohmann::ordered_json& value) {
  return fmt::format("<script type=\"text/plain\" class=\"packed\">{}</script>\n",
                     packed(json_bytes(value)));
}

}  // namespace lanescope

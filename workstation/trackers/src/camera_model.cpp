#include "ew/trackers/camera_model.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"

namespace ew {
namespace {

/// The lens alone: where a ray (X/Z, Y/Z) leaves it, and how that changes with the ray.
struct RayDistortion {
  glm::dvec2 at{0.0};
  glm::dmat2 slope{1.0};  ///< columns: by x, by y
};

RayDistortion bent(const std::array<double, 5>& k, const glm::dvec2& ray) {
  const auto [k1, k2, p1, p2, k3] = k;
  const double x = ray.x, y = ray.y, r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double radialSlope = k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3);  // by r2
  RayDistortion found;
  found.at = {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x), y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
  const double across = 2.0 * x * y * radialSlope + 2.0 * p1 * x + 2.0 * p2 * y;
  found.slope[0] = {radial + 2.0 * x * x * radialSlope + 2.0 * p1 * y + 6.0 * p2 * x, across};
  found.slope[1] = {across, radial + 2.0 * y * y * radialSlope + 6.0 * p1 * y + 2.0 * p2 * x};
  return found;
}

}  // namespace

glm::dvec2 pixelOf(const CameraModel& model, const glm::dvec3& p_camera) {
  const glm::dvec2 at = bent(model.distortion, glm::dvec2(p_camera) / p_camera.z).at;
  return {model.fx * at.x + model.cx, model.fy * at.y + model.cy};
}

glm::dvec2 rayThrough(const CameraModel& model, const glm::dvec2& p_px) {
  const glm::dvec2 wanted{(p_px.x - model.cx) / model.fx, (p_px.y - model.cy) / model.fy};
  glm::dvec2 ray = wanted;
  for (int step = 0; step < 12; ++step) {
    const RayDistortion now = bent(model.distortion, ray);
    const glm::dvec2 miss = wanted - now.at;
    if (glm::dot(miss, miss) < 1e-22) break;
    // Beyond the fold of a strong lens the slope turns over; a plain step leads back to where the lens maps one to one.
    ray += glm::determinant(now.slope) > 0.05 ? glm::inverse(now.slope) * miss : miss;
  }
  return ray;
}

CameraModel assumedCamera(int width, int height, double fieldOfView_rad) {
  CameraModel model;
  model.width = width;
  model.height = height;
  model.fx = model.fy = 0.5 * width / std::tan(0.5 * fieldOfView_rad);
  model.cx = 0.5 * (width - 1);
  model.cy = 0.5 * (height - 1);
  return model;
}

Result<CameraModel> scaledTo(const CameraModel& model, int width, int height) {
  const double byWidth = static_cast<double>(width) / model.width, byHeight = static_cast<double>(height) / model.height;
  if (std::abs(byWidth / byHeight - 1.0) > 0.01)
    return failure(ErrorCode::badField,
                   say<"The camera was calibrated with images of %1 x %2 pixels and now delivers %3 x %4, which is another part of what it "
                       "sees; calibrate it again at this size.">(model.width, model.height, width, height),
                   {{"found", std::to_string(width) + " x " + std::to_string(height)}});
  CameraModel scaled = model;
  scaled.width = width;
  scaled.height = height;
  scaled.fx *= byWidth;
  scaled.fy *= byHeight;
  scaled.cx = (model.cx + 0.5) * byWidth - 0.5;  // pixels have their centres at whole numbers
  scaled.cy = (model.cy + 0.5) * byHeight - 0.5;
  scaled.rms_px *= byWidth;
  return scaled;
}

std::string cameraModelText(const CameraModel& model) {
  nlohmann::ordered_json text;
  text["format"] = CameraModel::kFormat;
  text["camera"] = model.camera;
  text["width"] = model.width;
  text["height"] = model.height;
  text["fx"] = model.fx;
  text["fy"] = model.fy;
  text["cx"] = model.cx;
  text["cy"] = model.cy;
  text["distortion"] = model.distortion;
  text["rms_px"] = model.rms_px;
  text["views"] = model.views;
  text["made"] = model.made;
  return text.dump(1) + "\n";
}

Result<CameraModel> parseCameraModel(std::string_view text, const Message& where) {
  const auto document = parseJsonObject(text, where);
  if (!document) return passOn(document.error());
  JsonReading reading(where, {"note"});
  const JsonFields fields(*document, reading);
  const long long format = fields.whole("format", 1, 1000000);
  if (reading.good() && format > CameraModel::kFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2 and this program reads formats up to %3; calibrate the camera again or update the program.">(
                       where, format, CameraModel::kFormat));
  fields.only({"format", "camera", "width", "height", "fx", "fy", "cx", "cy", "distortion", "rms_px", "views", "made", "note"});
  CameraModel model;
  model.camera = fields.text("camera", "", 0);
  model.width = static_cast<int>(fields.whole("width", 16, 16384));
  model.height = static_cast<int>(fields.whole("height", 16, 16384));
  model.fx = fields.number("fx", 1.0, 1e6);
  model.fy = fields.number("fy", 1.0, 1e6);
  model.cx = fields.number("cx", -1e5, 1e5);
  model.cy = fields.number("cy", -1e5, 1e5);
  const auto lens = fields.numbers("distortion", 5, 5, -1000.0, 1000.0);
  if (lens.size() == 5) std::copy(lens.begin(), lens.end(), model.distortion.begin());
  model.rms_px = fields.number("rms_px", 0.0, 1000.0, 0.0);
  model.views = static_cast<int>(fields.whole("views", 0, 100000, 0));
  model.made = fields.text("made", "", 0, 40);
  if (reading.problem()) return passOn(*reading.problem());
  return model;
}

}  // namespace ew

#pragma once

#include <string_view>

namespace ew {

/// Names of the fields that a sequence can carry beside its images and poses; per frame in SequenceFrame::otherFields (in the file
/// `Seq_Frame0000_EcgMillivolt = 0.93`), of the whole recording in Sequence::otherFields. Numbers are written in the C locale.
namespace fields {

// Gating, per frame, at the moment the image was formed.
inline constexpr std::string_view kEcg = "EcgMillivolt";              ///< electrocardiogram, mV; a beat begins at its R peak
inline constexpr std::string_view kRespiration = "RespirationShare";  ///< 0: end of expiration; 1: full inspiration

// A motor that carries the probe. The face's pose at value 0 is one pose of the recording's tracker frame; the motor moves the probe in
// its own frame: parallel along +z, fan about the x axis through (0, -MotorAxisBehindFaceMm, 0), rotational about the y axis; positive
// angles by the right hand.
inline constexpr std::string_view kMotorKind = "MotorKind";                             ///< recording: PARALLEL, FAN or ROTATIONAL
inline constexpr std::string_view kMotorAxisBehindFace = "MotorAxisBehindFaceMm";       ///< recording: fan; 0: in the face
inline constexpr std::string_view kMotorStart = "MotorStartProbeToReferenceTransform";  ///< recording: the pose at value 0, 16 numbers
inline constexpr std::string_view kMotorPosition = "MotorPositionMm";                   ///< per frame: parallel
inline constexpr std::string_view kMotorAngle = "MotorAngleDeg";                        ///< per frame: fan and rotational

// Where scan lines lie that are written one a row (orientation FM: sample s of line n is pixel (s, n)). The names inside are those of
// the PLUS toolkit's scan conversion. Sector: line n leaves the arc's centre at ThetaStartDeg + n (ThetaStopDeg - ThetaStartDeg) /
// (lines - 1), 0 straight down, positive towards the marker, from RadiusStartMm (the face) to RadiusStopMm. Linear: line n lies
// (n / (lines - 1) - 1/2) TransducerWidthMm from the middle. First and last sample lie at the ends of a line.
inline constexpr std::string_view kTransducerGeometry = "ScanConversionTransducerGeometry";  ///< CURVILINEAR or LINEAR
inline constexpr std::string_view kRadiusStart = "ScanConversionRadiusStartMm";              ///< curvilinear; 0 for a phased array
inline constexpr std::string_view kRadiusStop = "ScanConversionRadiusStopMm";
inline constexpr std::string_view kThetaStart = "ScanConversionThetaStartDeg";
inline constexpr std::string_view kThetaStop = "ScanConversionThetaStopDeg";
inline constexpr std::string_view kImagingDepth = "ScanConversionImagingDepthMm";        ///< linear
inline constexpr std::string_view kTransducerWidth = "ScanConversionTransducerWidthMm";  ///< linear, between the outermost lines
/// Of the image the lines are meant to become (orientation MF), for which the recording's ImageToProbe holds.
inline constexpr std::string_view kOutputSpacing = "ScanConversionOutputImageSpacingMmPerPixel";  ///< two numbers
inline constexpr std::string_view kOutputSize = "ScanConversionOutputImageSizePixel";             ///< two numbers
inline constexpr std::string_view kTransducerCentre = "ScanConversionTransducerCenterPixel";      ///< the middle of the face, two numbers

// Which pixels of the images are echoes, of the recording, in pixels of orientation MF; names and meaning as in a device set.
inline constexpr std::string_view kClipOrigin = "ClipRectangleOrigin";  ///< two numbers
inline constexpr std::string_view kClipSize = "ClipRectangleSize";      ///< two numbers
inline constexpr std::string_view kFanAngles = "FanAnglesDeg";          ///< two numbers
inline constexpr std::string_view kFanOrigin = "FanOriginPixel";        ///< two numbers
inline constexpr std::string_view kFanRadiusStart = "FanRadiusStartPixel";
inline constexpr std::string_view kFanRadiusStop = "FanRadiusStopPixel";

}  // namespace fields

}  // namespace ew

#pragma once

#include "ew/core/word_table.h"
#include "ew/stitching/project.h"

namespace ew::stitching {

// The words of a stitch project, as files, reports and sentences have them.
inline constexpr WordTable<Placement, 3> kPlacementWords{
    {{"unknown", Placement::unknown}, {"tracker", Placement::tracker}, {"hand", Placement::hand}}};
inline constexpr WordTable<PairMethod, 5> kPairMethodWords{{{"automatic", PairMethod::automatic},
                                                            {"search", PairMethod::search},
                                                            {"refine", PairMethod::refine},
                                                            {"landmarks", PairMethod::landmarks},
                                                            {"by hand", PairMethod::byHand}}};
inline constexpr WordTable<Decision, 3> kDecisionWords{
    {{"undecided", Decision::undecided}, {"accepted", Decision::accepted}, {"rejected", Decision::rejected}}};
inline constexpr WordTable<registration::ElasticEffort, 3> kElasticEffortWords{{{"fast", registration::ElasticEffort::fast},
                                                                                {"balanced", registration::ElasticEffort::balanced},
                                                                                {"accurate", registration::ElasticEffort::accurate}}};
inline constexpr WordTable<SeamMethod, 3> kSeamMethodWords{
    {{"feather", SeamMethod::feather}, {"nearest", SeamMethod::nearest}, {"graph cut", SeamMethod::graphCut}}};
inline constexpr WordTable<GridAxes, 2> kGridAxesWords{{{"first", GridAxes::first}, {"world", GridAxes::world}}};

}  // namespace ew::stitching

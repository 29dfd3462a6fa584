#include "io/json/valve_json.h"

#include <bit>
#include <cmath>
#include <functional>

#include "io/json/json.h"
#include "tests/io/json/found.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

using enum ErrorCode;

Json small_json() { return Json::parse(write_valve(small_valve())); }

// What the reader finds in the small valve's file after `spoil`.
Found found(const std::function<void(Json&)>& spoil) {
  Json document = small_json();
  spoil(document);
  return problems_of(read_valve(document.dump()));
}

Found found_with(const std::string& at, const Json& value) {
  return found([&](Json& document) { document[Json::json_pointer(at)] = value; });
}

bool same_bits(const Points& a, const Points& b) {
  if (a.rows() != b.rows()) return false;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (std::bit_cast<std::uint64_t>(a.data()[i]) != std::bit_cast<std::uint64_t>(b.data()[i])) {
      return false;
    }
  }
  return true;
}

TEST(ValveJson, RoundTripGivesTheSameBits) {
  Valve valve = small_valve();
  valve.rest_mm(9, 0) = std::nextafter(valve.rest_mm(9, 0), 0.0);
  valve.rest_mm(0, 1) = -0.0;
  valve.rest_mm(0, 2) = 5e-324;
  valve.chordae[0].ruptured = true;
  valve.name = "valve \"\u00e9\"\n";
  const auto read = read_valve(write_valve(valve));
  ASSERT_TRUE(read);
  EXPECT_TRUE(same_bits(read->rest_mm, valve.rest_mm));
  EXPECT_TRUE(same_bits(read->fibre, valve.fibre));
  EXPECT_TRUE(same_bits(read->annulus_mm, valve.annulus_mm));
  EXPECT_EQ(read->faces, valve.faces);
  EXPECT_EQ(read->segments, valve.segments);
  EXPECT_EQ(read->name, valve.name);
  EXPECT_TRUE(read->chordae[0].ruptured);
  EXPECT_EQ(read->chordae[1].segments[0].rest_length_mm,
            valve.chordae[1].segments[0].rest_length_mm);
  EXPECT_EQ(read->landmarks.mid_posterior, 6);
  EXPECT_EQ(write_valve(*read), write_valve(valve));
}

TEST(ValveJson, ThePatientsFrameIsReadAsItIsWritten) {
  Valve valve = small_valve();
  EXPECT_EQ(write_valve(valve).find("patient_frame"), std::string::npos);
  PatientFrame frame;
  frame.axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  frame.origin_mm = Vec3(12.5, -80.25, 1030.125);
  valve.patient = frame;
  const auto read = read_valve(write_valve(valve));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->patient, frame);
}

TEST(ValveJson, WhatWasObservedIsReadAsItIsWritten) {
  Valve valve = small_valve();
  EXPECT_EQ(write_valve(valve).find("observed"), std::string::npos);
  valve.observed = {{ObservedFigure::Leak, 30.0, 8.0, "3D planimetry"},
                    {ObservedFigure::WidestGap, 2.5, 0.5, ""}};
  const auto read = read_valve(write_valve(valve));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->observed, valve.observed);
}

TEST(ValveJson, WhatWasObservedHasRangesAndKnownNames) {
  const auto found_of = [](const Json& leak) {
    return found([&](Json& document) { document["observed"] = {{"leak_mm2", leak}}; });
  };
  EXPECT_EQ(found_of({{"value", 30}, {"sd", 8}}), Found{});
  EXPECT_EQ(found_of({{"value", 30}, {"sd", 0}}), (Found{{OutOfRange, "/observed/leak_mm2/sd"}}));
  EXPECT_EQ(found_of({{"value", -1}, {"sd", 8}}),
            (Found{{OutOfRange, "/observed/leak_mm2/value"}}));
  EXPECT_EQ(
      found_of({{"value", 1e300}, {"sd", -3}}),
      (Found{{OutOfRange, "/observed/leak_mm2/value"}, {OutOfRange, "/observed/leak_mm2/sd"}}));
  EXPECT_EQ(found_of({{"value", 30}}), (Found{{MissingField, "/observed/leak_mm2/sd"}}));
  EXPECT_EQ(found_of({{"value", 30}, {"sd", 8}, {"kind", "PISA"}}),
            (Found{{UnknownField, "/observed/leak_mm2/kind"}}));
  EXPECT_EQ(found([](Json& document) {
              document["observed"] = {{"eroa_mm2", 30}};
            }),
            (Found{{UnknownField, "/observed/eroa_mm2"}}));
}

TEST(ValveJson, WhatAFitLeftUncertainIsReadAsItIsWritten) {
  Valve valve = small_valve();
  Eigen::Matrix2d covariance;
  covariance << 0.1, 0.02, 0.02, 0.3;
  valve.fitted = FittedValues{{"slack_anterior_AL", "tip_AL_x"}, covariance};
  const auto read = read_valve(write_valve(valve));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->fitted->parameters, valve.fitted->parameters);
  EXPECT_EQ(read->fitted->covariance, valve.fitted->covariance);
}

TEST(ValveJson, AFrameThatIsNoneIsNamed) {
  using enum ErrorCode;
  const auto found_as = [](const char* rows) {
    return found_with("/patient_frame", Json::parse(rows));
  };
  const Found shape{{BadGeometry, "/patient_frame"}};
  EXPECT_EQ(found_as("[]"), shape);
  EXPECT_EQ(found_as("[[1,0,0,0],[0,1,0,0],[0,0,1],[0,0,0,1]]"), shape);
  EXPECT_EQ(found_as("[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,2]]"), shape);
  EXPECT_EQ(found_as("[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"), shape) << "mirrored";
  EXPECT_EQ(found_as("[[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]]"), shape) << "scaled";
  EXPECT_EQ(found_as("[[1,0,0,0],[0,1,0,1e9],[0,0,1,0],[0,0,0,1]]"),
            (Found{{OutOfRange, "/patient_frame/1/3"}}));
}

TEST(ValveJson, APointTakesOneLine) {
  EXPECT_NE(write_valve(small_valve()).find("\n    [18.0,0.0,0.0],\n"), std::string::npos);
}

TEST(ValveJson, BytesThatAreNotUtf8AreReplacedInWriting) {
  Valve valve = small_valve();
  valve.name = "\xff";
  const auto read = read_valve(write_valve(valve));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name, "\uFFFD");
}

TEST(ValveJson, EveryFieldOfRelease01IsRequired) {
  const std::set<std::string> later = {"reference", "circumferential_prestretch",
                                       "radial_prestretch", "bending_n_mm"};
  const std::vector<std::string> objects = {"",
                                            "/tissue",
                                            "/annulus",
                                            "/landmarks",
                                            "/papillary_heads/1",
                                            "/chordae/1",
                                            "/chordae/1/segments/0/insertion"};
  for (const std::string& object : objects) {
    const Json members = small_json()[Json::json_pointer(object)];
    for (const auto& [name, value] : members.items()) {
      if (later.contains(name)) continue;
      const std::string missing = name;
      const auto erase = [&](Json& d) { d[Json::json_pointer(object)].erase(missing); };
      EXPECT_EQ(found(erase), (Found{{MissingField, object + "/" + missing}}));
    }
  }
}

TEST(ValveJson, UnknownFieldsAreNamed) {
  EXPECT_EQ(found_with("/colour", "red"), (Found{{UnknownField, "/colour"}}));
  EXPECT_EQ(found_with("/a~1b", 1), (Found{{UnknownField, "/a~1b"}}));
  EXPECT_EQ(found_with("/chordae/0/segments/1/length", 3),
            (Found{{UnknownField, "/chordae/0/segments/1/length"}}));
}

TEST(ValveJson, ASegmentHasEitherAnInsertionOrABranchPoint) {
  EXPECT_EQ(found_with("/chordae/0/segments/1/branch_point_mm", {0, 0, -9}),
            (Found{{UnknownField, "/chordae/0/segments/1"}}));
  EXPECT_EQ(found([](Json& d) { d["chordae"][0]["segments"][0].erase("branch_point_mm"); }),
            (Found{{MissingField, "/chordae/0/segments/0"}}));
}

TEST(ValveJson, WrongTypesAreNamedAsDeepAsTheyLie) {
  EXPECT_EQ(found_with("/pressure_kpa", "16"), (Found{{WrongType, "/pressure_kpa"}}));
  EXPECT_EQ(found_with("/pressure_kpa", nullptr), (Found{{WrongType, "/pressure_kpa"}}));
  EXPECT_EQ(found_with("/vertices_mm/3/1", true), (Found{{WrongType, "/vertices_mm/3/1"}}));
  EXPECT_EQ(found_with("/vertices_mm/3", {1.0, 2.0}), (Found{{OutOfRange, "/vertices_mm/3"}}));
  EXPECT_EQ(found_with("/vertices_mm", 7), (Found{{WrongType, "/vertices_mm"}}));
  EXPECT_EQ(found_with("/faces/3/1", 1.0), (Found{{WrongType, "/faces/3/1"}}));
  EXPECT_EQ(found_with("/chordae/0/ruptured", 0), (Found{{WrongType, "/chordae/0/ruptured"}}));
  EXPECT_EQ(found_with("/chordae/0/segments/1/rest_length_mm", "7"),
            (Found{{WrongType, "/chordae/0/segments/1/rest_length_mm"}}));
  EXPECT_EQ(problems_of(read_valve("[]")).front(),
            (std::pair<ErrorCode, std::string>{WrongType, ""}));
}

TEST(ValveJson, NamesAndSchemaThatAreNotKnownAreRefused) {
  EXPECT_EQ(found_with("/schema", "coapt.valve/2"), (Found{{Unsupported, "/schema"}}));
  EXPECT_EQ(found_with("/segments/0", "A4"), (Found{{BadReference, "/segments/0"}}));
  EXPECT_EQ(found_with("/papillary_heads/0/side", "left"),
            (Found{{BadReference, "/papillary_heads/0/side"}}));
  EXPECT_EQ(found_with("/chordae/0/kind", "Marginal"), (Found{{BadReference, "/chordae/0/kind"}}));
}

TEST(ValveJson, IndicesBeyondAnyMeshAreRefused) {
  EXPECT_EQ(found_with("/faces/0/0", 1'000'000'000'000'000'000),
            (Found{{OutOfRange, "/faces/0/0"}}));
  EXPECT_EQ(found_with("/faces/0/0", 18'446'744'073'709'551'615u),
            (Found{{OutOfRange, "/faces/0/0"}}));
  EXPECT_EQ(found_with("/faces/0/0", -1), (Found{{BadReference, "/faces/0/0"}}));
  EXPECT_EQ(found_with("/chordae/1/head", 4'294'967'296), (Found{{OutOfRange, "/chordae/1/head"}}));
}

TEST(ValveJson, WhatValidateFindsIsListedBesideWhatTheFormGetsWrong) {
  const auto spoil = [](Json& d) {
    d["pressure_kpa"] = 1e6;
    d["tissue"]["thickness_mm"] = "thin";
    d["faces"][7][2] = 99;
    d["chordae"][0]["segments"][0]["parent"] = 0;
  };
  EXPECT_EQ(found(spoil), (Found{{WrongType, "/tissue/thickness_mm"},
                                 {OutOfRange, "/pressure_kpa"},
                                 {BadReference, "/faces/7/2"},
                                 {BadTopology, "/chordae/0/segments/0/parent"},
                                 {BadTopology, "/chordae/0/segments/1"},
                                 {BadTopology, "/chordae/0/segments/2"}}));
}

TEST(ValveJson, TopologyAndGeometryComeFromValidate) {
  const auto flip = [](Json& d) { std::swap(d["faces"][5][0], d["faces"][5][1]); };
  EXPECT_EQ(found(flip), (Found{{BadGeometry, "/faces/5"}}));
}

TEST(ValveJson, EmptyArraysAreProblemsNotCrashes) {
  EXPECT_EQ(found_with("/vertices_mm", Json::array()), (Found{{OutOfRange, "/vertices_mm"}}));
  EXPECT_EQ(found_with("/faces", Json::array()), (Found{{OutOfRange, "/faces"}}));
  EXPECT_EQ(found_with("/annulus/vertices", Json::array()),
            (Found{{OutOfRange, "/annulus/vertices"}}));
  EXPECT_EQ(found_with("/papillary_heads", Json::array()),
            (Found{{OutOfRange, "/papillary_heads"}}));
  EXPECT_EQ(found_with("/chordae/0/segments", Json::array()),
            (Found{{OutOfRange, "/chordae/0/segments"}}));
  EXPECT_EQ(found_with("/chordae", Json::array()), Found{});
  EXPECT_EQ(found_with("/provenance", Json::array()), Found{});
}

TEST(ValveJson, MillionsOfProblemsAreNotAllCounted) {
  Json document = small_json();
  document["segments"] = std::vector<int>(1'000'000, 0);
  const auto read = read_valve(document.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.errors().size(), 201u);
  EXPECT_EQ(read.errors().back().message, "at least 10000 more problems, not listed");
}

TEST(ValveJson, ProblemsThatAreNotListedAreCountedBesideProblemsOfForm) {
  // One wrong type, and 251 chordae without a head: 200 are listed.
  const auto spoil = [](Json& d) {
    d["name"] = 7;
    Json chorda = d["chordae"][1];
    chorda["head"] = 9;
    d["chordae"] = Json::array();
    for (int i = 0; i < 251; ++i) {
      chorda["id"] = std::to_string(i);
      d["chordae"].push_back(chorda);
    }
  };
  Json document = small_json();
  spoil(document);
  const auto read = read_valve(document.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.errors().size(), 201u);
  EXPECT_EQ(read.errors().front().path, "/name");
  EXPECT_EQ(read.errors().back().message, "52 more problems, not listed");
}

TEST(ValveJson, EveryPrefixOfAFileIsRefused) {
  const std::string text = small_json().dump();
  for (std::size_t size = 0; size < text.size(); size += 7) {
    const Found list = problems_of(read_valve(std::string_view(text).substr(0, size)));
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].first, InvalidJson);
  }
}

}  // namespace
}  // namespace coapt

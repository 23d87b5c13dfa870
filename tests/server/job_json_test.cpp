#include "server/json/job_json.hpp"

#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::server {
namespace {

Result<jobs::PostJob> read_parts(JobParts parts) {
  static const auto machines = sample::library();
  const auto dialects = dialect_names();
  return read_post_job(std::move(parts), {.machines = machines, .dialects = dialects});
}

Result<jobs::PostJob> read(const std::string& json) { return read_parts({.json = json}); }

/// A job with further members.
Result<jobs::PostJob> read_with(const std::string& members) {
  return read(R"({"machine": "demo", "cl": "GOTO/1,2,3", )" + members + "}");
}

Result<jobs::AnalyseJob> read_analysis(JobParts parts) {
  static const auto machines = sample::library();
  const auto dialects = dialect_names();
  return read_analyse_job(std::move(parts), {.machines = machines, .dialects = dialects});
}

TEST(AnalyseJobJson, ReadsAnNcProgram) {
  const auto job = read_analysis(
      {.json = R"({"machine": "demo", "nc": "%\nM30\n", "nc_dialect": "fanuc-30i", "cl": null})"});
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->nc.value().text, "%\nM30\n");
  EXPECT_EQ(job->nc->dialect, "fanuc-30i");
  const auto silent = read_analysis({.json = R"({"machine": "demo", "nc": ""})"});
  ASSERT_TRUE(silent) << silent.error().message;
  EXPECT_EQ(silent->nc.value().dialect, std::nullopt);
}

TEST(AnalyseJobJson, TakesAnNcProgramApart) {
  const auto job = read_analysis(
      {.json = R"({"machine": "demo"})", .nc = "%", .words = {{"nc_dialect", "heidenhain-iso"}}});
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->nc.value().text, "%");
  EXPECT_EQ(job->nc->dialect, "heidenhain-iso");
}

TEST(AnalyseJobJson, HasOnePath) {
  const auto refused = [](const std::string& members, const char* pointer) {
    const auto job = read_analysis({.json = R"({"machine": "demo", )" + members + "}"});
    ASSERT_FALSE(job) << members;
    EXPECT_EQ(job.error().pointer, pointer) << members;
  };
  refused(R"("nc": "%", "cl": "GOTO/1,2,3")", "/cl");
  refused(R"("nc": "%", "path": {})", "/path");
  refused(R"("nc": "%", "cl_units": "mm")", "/cl_units");
  refused(R"("cl": "GOTO/1,2,3", "nc_dialect": "fanuc-30i")", "/nc_dialect");
  refused(R"("nc": "%", "nc_dialect": "sinumerik")", "/nc_dialect");
  refused(R"("nc": 1)", "/nc");
  refused(R"("nc": null)", "/cl");
  EXPECT_EQ(read_analysis({.json = R"({"machine": "demo", "nc": "%"})", .cl = "GOTO/1,2,3"})
                .error()
                .pointer,
            "/cl");
}

TEST(JobJson, RefusesAnNcProgram) {
  EXPECT_EQ(read_with(R"("nc": "%")").error().code, Code::unknown_key);
  EXPECT_EQ(read_parts({.json = R"({"machine": "demo"})", .nc = "%"}).error().pointer, "/nc");
}

TEST(JobJson, ReadsTheChangeOfTheAxisNearAPole) {
  const auto job = read_with(R"("post": {"pole_axis_deg": 1.5})");
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->post.pole_axis_deg, 1.5);
  EXPECT_EQ(read_with(R"("post": {})")->post.pole_axis_deg, 0.0);
  for (const char* wrong : {"5.5", "-1", "true"}) {
    const auto refused = read_with(std::string{R"("post": {"pole_axis_deg": )"} + wrong + "}");
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().pointer, "/post/pole_axis_deg");
  }
}

TEST(JobJson, ReadsEveryKey) {
  const auto job = read(R"({
    "machine": "demo@1.0.0", "cl": "GOTO/1,2,3\n", "cl_units": "inch", "cl_dialect": "nx",
    "setup": {"origin_mm": [1, 2, 3], "theta_x_deg": -10, "theta_z_deg": 20},
    "tools": {"1": {"gauge_length_mm": 120.5}, "0": {"gauge_length_mm": 0}, "7": {}},
    "tolerances": {"tip_mm": 0.02, "axis_deg": 0.1},
    "post": {"output": "axes", "dialect": "heidenhain-iso", "program_name": "P", "flank": true,
             "prefer": {"tilt": "negative", "first_turn_deg": [-180, 180]}},
    "limits": {"C": {"max_speed_deg_s": 180, "max_acceleration_deg_s2": 360, "max_jerk_deg_s3": 90},
               "X": {"max_speed_mm_s": 250, "max_acceleration_mm_s2": 500, "max_jerk_mm_s3": 3000}}
  })");
  ASSERT_TRUE(job) << job.error().message;

  EXPECT_EQ(job->machine.version, "1.0.0");
  const auto& cl = std::get<jobs::ClText>(job->path);
  EXPECT_EQ(cl.text, "GOTO/1,2,3\n");
  EXPECT_EQ(cl.units, jobs::ClUnits::inch);
  EXPECT_EQ(cl.dialect, "nx");
  EXPECT_EQ(job->setup.origin_mm, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(job->setup.theta_x_deg, -10.0);
  EXPECT_EQ(job->setup.theta_z_deg, 20.0);
  EXPECT_EQ(job->gauge_length_mm, (std::map<int, double>{{0, 0.0}, {1, 120.5}}));
  EXPECT_EQ(job->tolerances.tip_mm, 0.02);
  EXPECT_EQ(job->tolerances.axis_deg, 0.1);
  EXPECT_EQ(job->post.output, Output::axes);
  EXPECT_EQ(job->post.dialect, "heidenhain-iso");
  EXPECT_EQ(job->post.program_name, "P");
  EXPECT_TRUE(job->post.flank);
  EXPECT_EQ(job->post.prefer->tilt, machine::Preferences::Tilt::negative);
  EXPECT_EQ(job->post.prefer->first_turn,
            (Range<Angle>{Angle::degrees(-180), Angle::degrees(180)}));
  EXPECT_NEAR(job->limits.at("C").max_speed.value(), 3.14159265358979, 1e-13);
  EXPECT_NEAR(job->limits.at("C").max_acceleration.value(), 6.28318530717959, 1e-13);
  EXPECT_NEAR(job->limits.at("C").max_jerk.value(), 1.57079632679490, 1e-13);
  EXPECT_EQ(job->limits.at("X").max_speed, 250.0);
  EXPECT_EQ(job->limits.at("X").max_acceleration, 500.0);
  EXPECT_EQ(job->limits.at("X").max_jerk, 3000.0);
}

TEST(AnalyseJobJson, ReadsTheJobAndItsShare) {
  const auto job = read_analysis(
      {.json =
           R"({"machine": "demo", "cl": "x", "zone_share": 0.25, "tolerances": {"tip_mm": 0.02}})"});
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->zone_share, 0.25);
  EXPECT_EQ(job->job.tolerances.tip_mm, 0.02);
  EXPECT_EQ(std::get<jobs::ClText>(job->job.path).text, "x");
}

TEST(AnalyseJobJson, TakesTheShareAsAWord) {
  EXPECT_EQ(read_analysis({.cl = "x", .words = {{"machine", "demo"}, {"zone_share", "0.5"}}})
                .value()
                .zone_share,
            0.5);
  EXPECT_EQ(read_analysis({.cl = "x", .words = {{"machine", "demo"}}}).value().zone_share, 1.0);
}

TEST(AnalyseJobJson, RefusesAShareThatIsNotAboveZero) {
  for (const std::string share : {"0", "-1", "\"1\""}) {
    const auto job =
        read_analysis({.json = R"({"machine": "demo", "cl": "x", "zone_share": )" + share + "}"});
    ASSERT_FALSE(job) << share;
    EXPECT_EQ(job.error().pointer, "/zone_share");
  }
  for (const std::string share : {"0", "-1", "x", "", "nan", "inf", "1e999"}) {
    const auto job =
        read_analysis({.cl = "x", .words = {{"machine", "demo"}, {"zone_share", share}}});
    ASSERT_FALSE(job) << share;
    EXPECT_EQ(job.error().code, Code::out_of_domain) << share;
    EXPECT_EQ(job.error().pointer, "/zone_share");
  }
}

/// An analysis of CL data with further members.
Result<jobs::AnalyseJob> read_analysis_with(const std::string& members) {
  return read_analysis({.json = R"({"machine": "demo", "cl": "x", )" + members + "}"});
}

TEST(AnalyseJobJson, HasNoSamplesUnlessAskedFor) {
  EXPECT_EQ(read_analysis_with(R"("zone_share": 1)").value().samples, std::nullopt);
  EXPECT_EQ(read_analysis_with(R"("samples": false)").value().samples, std::nullopt);
  EXPECT_EQ(read_analysis_with(R"("samples": null, "max_samples": null)").value().samples,
            std::nullopt);
}

TEST(AnalyseJobJson, ReadsHowManySamplesAreWanted) {
  EXPECT_EQ(read_analysis_with(R"("samples": true)").value().samples, 2000U);
  EXPECT_EQ(read_analysis_with(R"("samples": true, "max_samples": 100)").value().samples, 100U);
  EXPECT_EQ(read_analysis_with(R"("samples": true, "max_samples": 100000)").value().samples,
            100'000U);
}

TEST(AnalyseJobJson, RefusesANumberOfSamplesOutsideItsDomain) {
  for (const std::string number : {"99", "100001", "-1"}) {
    const auto job = read_analysis_with(R"("samples": true, "max_samples": )" + number);
    ASSERT_FALSE(job) << number;
    EXPECT_EQ(job.error().code, Code::out_of_domain) << number;
    EXPECT_EQ(job.error().pointer, "/max_samples") << number;
  }
}

TEST(AnalyseJobJson, RefusesSamplesOfAWrongType) {
  for (const std::string members :
       {R"("samples": 1)", R"("samples": "true")", R"("samples": true, "max_samples": "200")"}) {
    const auto job = read_analysis_with(members);
    ASSERT_FALSE(job) << members;
    EXPECT_EQ(job.error().code, Code::wrong_type) << members;
  }
}

TEST(AnalyseJobJson, HasANumberOfSamplesOnlyWithSamples) {
  for (const std::string members : {"", R"("samples": false, )"}) {
    const auto job = read_analysis_with(members + R"("max_samples": 200)");
    ASSERT_FALSE(job) << members;
    EXPECT_EQ(job.error().code, Code::conflicting_keys) << members;
    EXPECT_EQ(job.error().pointer, "/max_samples") << members;
  }
}

TEST(JobJson, HasNoSamples) {
  for (const std::string key : {"samples", "max_samples"}) {
    const auto job = read_with('"' + key + R"(": 200)");
    ASSERT_FALSE(job) << key;
    EXPECT_EQ(job.error().code, Code::unknown_key) << key;
    EXPECT_EQ(job.error().pointer, "/" + key);
  }
}

TEST(JobJson, ReadsWhetherTheProgramWarnsOfZones) {
  EXPECT_TRUE(read_with(R"("post": {"zone_comments": true})").value().post.zone_comments);
  EXPECT_TRUE(read_with(R"("post": {"line_map": true})").value().post.line_map);
  EXPECT_FALSE(read_with(R"("post": {})").value().post.line_map);
  EXPECT_FALSE(read_with(R"("post": {})").value().post.zone_comments);
  const auto refused = read_with(R"("post": {"zone_comments": 1})");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::wrong_type);
  EXPECT_EQ(refused.error().pointer, "/post/zone_comments");
}

TEST(JobJson, HasNoZoneShare) {
  const auto json = read_with(R"("zone_share": 1)");
  ASSERT_FALSE(json);
  EXPECT_EQ(json.error().code, Code::unknown_key);
  EXPECT_EQ(json.error().pointer, "/zone_share");
  const auto text = read_parts({.cl = "x", .words = {{"machine", "demo"}, {"zone_share", "1"}}});
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, Code::unknown_key);
  EXPECT_EQ(text.error().pointer, "/zone_share");
}

TEST(JobJson, HasTheDefaultsOfTheContract) {
  const auto job = read(R"({"machine": "demo", "cl": ""})");
  ASSERT_TRUE(job);

  EXPECT_EQ(job->machine.version, "1.1.0");
  EXPECT_EQ(job->tolerances.tip_mm, 0.01);
  EXPECT_EQ(job->tolerances.axis_deg, 0.05);
  EXPECT_FALSE(job->setup.origin_mm);
  EXPECT_FALSE(job->post.output || job->post.dialect || job->post.program_name || job->post.prefer);
  EXPECT_FALSE(job->post.flank);
}

TEST(JobJson, TakesNullAsNotGiven) {
  const auto job = read_with(R"("post": {"dialect": null, "program_name": null}, "setup": null)");
  ASSERT_TRUE(job);

  EXPECT_FALSE(job->post.dialect);
}

TEST(JobJson, TakesNullAsNotGivenBesideEitherPath) {
  const std::string points = R"("path": {"feed_mm_min": 100, "points": [[0,0,0,0,0,1]]})";
  EXPECT_TRUE(read(R"({"machine": "demo", "cl": null, "cl_units": null, "cl_dialect": null, )" +
                   points + "}"));

  const auto without = read(R"({"machine": "demo", "cl": null})");
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().code, Code::missing_key);
}

TEST(JobJson, ReadsPoints) {
  const auto job = read(R"({"machine": "demo",
                            "path": {"feed_mm_min": 100, "points": [[1,2,3,0,0,1],[4,5,6,0,0.6,0.8]]}})");
  ASSERT_TRUE(job) << job.error().message;
  const auto& path = std::get<jobs::PointPath>(job->path);

  EXPECT_EQ(path.feed_mm_min, 100.0);
  ASSERT_EQ(path.tip_mm.size(), 2u);
  EXPECT_EQ(path.tip_mm[1], Vec3(4, 5, 6));
  EXPECT_EQ(path.axis[1], Vec3(0, 0.6, 0.8));
}

TEST(JobJson, ReadsAnInlineMachine) {
  const auto job =
      read(R"({"cl": "", "machine": )" + sample::definition_text("mine", "3.0.0") + "}");
  ASSERT_TRUE(job) << job.error().message;

  EXPECT_EQ(job->machine.name, "mine");
}

struct Refusal {
  std::string json;
  Code code;
  std::string pointer;
};

TEST(JobJson, RefusesWithThePlace) {
  const std::string start = R"({"machine": "demo", "cl": "", )";
  for (
      const auto& [json, code, pointer] : std::vector<Refusal>{
          {"", Code::bad_json, ""},
          {"{", Code::bad_json, ""},
          {"[]", Code::wrong_type, ""},
          {"{}", Code::missing_key, "/machine"},
          {R"({"cl": ""})", Code::missing_key, "/machine"},
          {R"({"machine": "demo"})", Code::missing_key, "/cl"},
          {R"({"machine": "demo", "path": {"points": []}})", Code::missing_key,
           "/path/feed_mm_min"},
          {R"({"machine": 5, "cl": ""})", Code::wrong_type, "/machine"},
          {R"({"machine": "dmeo", "cl": ""})", Code::unknown_machine, "/machine"},
          {R"({"machine": "demo@9.0.0", "cl": ""})", Code::unknown_version, "/machine"},
          {R"({"machine": "demo@", "cl": ""})", Code::unknown_version, "/machine"},
          {R"({"machine": {}, "cl": ""})", Code::definition_schema, "/machine"},
          {start + R"("path": {"feed_mm_min": 1, "points": [[0,0,0,0,0,1]]}})",
           Code::conflicting_keys, "/path"},
          {start + R"("cl": ""})", Code::bad_json, "/cl"},
          {start + R"("tolerance": {}})", Code::unknown_key, "/tolerance"},
          {start + R"("dual_nurbs": {}})", Code::unknown_key, "/dual_nurbs"},
          {R"({"machine": "demo", "nc": "M30"})", Code::unknown_key, "/nc"},
          {start + R"("tolerances": {"tip_mm": 0}})", Code::out_of_domain, "/tolerances/tip_mm"},
          {start + R"("tolerances": {"tip_mm": -1}})", Code::out_of_domain, "/tolerances/tip_mm"},
          {start + R"("tolerances": {"tip_mm": 1.001}})", Code::out_of_domain,
           "/tolerances/tip_mm"},
          {start + R"("tolerances": {"axis_deg": 5.001}})", Code::out_of_domain,
           "/tolerances/axis_deg"},
          {start + R"("setup": {"theta_x_deg": 1e9}})", Code::out_of_domain, "/setup/theta_x_deg"},
          {start + R"("setup": {"theta_z_deg": -361}})", Code::out_of_domain, "/setup/theta_z_deg"},
          {start + R"("tolerances": {"axis_deg": "1"}})", Code::wrong_type, "/tolerances/axis_deg"},
          {start + R"("tolerances": {"axis_deg": 1e999}})", Code::bad_number,
           "/tolerances/axis_deg"},
          {start + R"("tolerances": {"axis_deg": NaN}})", Code::bad_json, ""},
          {start + R"("tolerances": {"a/b~": 1}})", Code::unknown_key, "/tolerances/a~1b~0"},
          {start + R"("cl_units": "cm"})", Code::out_of_domain, "/cl_units"},
          {start + R"("setup": {"origin_mm": [1, 2]}})", Code::wrong_type, "/setup/origin_mm"},
          {start + R"("setup": {"origin_mm": [0, 0, -1000001]}})", Code::out_of_domain,
           "/setup/origin_mm"},
          {start + R"("tools": {"1": {"gauge_length_mm": 1000001}}})", Code::out_of_domain,
           "/tools/1/gauge_length_mm"},
          {start + R"("tools": {"x": {}}})", Code::out_of_domain, "/tools/x"},
          {start + R"("tools": {"01": {}}})", Code::out_of_domain, "/tools/01"},
          {start + R"("tools": {"-1": {}}})", Code::out_of_domain, "/tools/-1"},
          {start + R"("tools": {"1": {"gauge_length_mm": -1}}})", Code::out_of_domain,
           "/tools/1/gauge_length_mm"},
          {start + R"("tools": {"1": {"length": 1}}})", Code::unknown_key, "/tools/1/length"},
          {start + R"("post": {"output": "joints"}})", Code::out_of_domain, "/post/output"},
          {start + R"("post": {"dialect": "fanuc"}})", Code::unknown_dialect, "/post/dialect"},
          {start + R"("post": {"prefer": {"tilt": 1}}})", Code::wrong_type, "/post/prefer/tilt"},
          {start + R"("limits": {"B": {"max_speed_deg_s": 1}}})", Code::out_of_domain, "/limits/B"},
          {start + R"("limits": {"X": {"max_speed_deg_s": 1}}})", Code::unknown_key,
           "/limits/X/max_speed_deg_s"},
          {start + R"("limits": {"C": {"max_speed_deg_s": 0}}})", Code::out_of_domain,
           "/limits/C/max_speed_deg_s"},
          {R"({"machine": "demo", "path": {"feed_mm_min": 0, "points": [[0,0,0,0,0,1]]}})",
           Code::out_of_domain, "/path/feed_mm_min"},
          {R"({"machine": "demo", "path": {"feed_mm_min": 1, "points": []}})", Code::no_motion,
           "/path/points"},
          {R"({"machine": "demo", "path": {"feed_mm_min": 1, "points": [[0,0,0,0,0,1],[0,0,0,0,1]]}})",
           Code::wrong_type, "/path/points/1"},
          {R"({"machine": "demo", "path": {"feed_mm_min": 1, "points": [[0,0,0,0,0,0]]}})",
           Code::zero_tool_axis, "/path/points/0"},
          {R"({"machine": "demo", "cl_units": "mm", "path": {"feed_mm_min": 1, "points": [[0,0,0,0,0,1]]}})",
           Code::conflicting_keys, "/cl_units"},
      }) {
    SCOPED_TRACE(json);
    const auto job = read(json);
    ASSERT_FALSE(job);
    EXPECT_EQ(row_of(job.error().code).name, row_of(code).name) << job.error().message;
    EXPECT_EQ(job.error().pointer, pointer);
    EXPECT_FALSE(job.error().message.empty());
  }
}

TEST(JobJson, SaysWhatAMachineCanBe) {
  const auto job = read(R"({"machine": 5, "cl": ""})");
  ASSERT_FALSE(job);
  EXPECT_NE(job.error().message.find("name@version"), std::string::npos) << job.error().message;
  EXPECT_NE(job.error().message.find("object"), std::string::npos) << job.error().message;
}

TEST(JobJson, RefusesAReversedRangeAsAnUnusableDefinition) {
  auto text = sample::definition_text("mine", "1.0.0");
  text.replace(text.find("[-110, 110]"), 11, "[110, -110]");
  const auto job = read(R"({"cl": "", "machine": )" + text + "}");
  ASSERT_FALSE(job);
  EXPECT_EQ(job.error().code, Code::definition_meaning);
  EXPECT_EQ(job.error().pointer, "/machine/axes/A/range_deg");
}

TEST(JobWords, SayValueAndLimitOfATolerance) {
  const auto job = read_parts({.cl = "", .words = {{"machine", "demo"}, {"axis_deg", "360"}}});
  ASSERT_FALSE(job);
  EXPECT_EQ(job.error().message, "found '360', expected a number above 0 and of at most 5");
}

TEST(JobFileName, NamesAProgramWithoutADirectoryAndEnding) {
  for (const auto& [file_name, name] : std::vector<std::pair<std::string, std::string>>{
           {"", ""},
           {"part.cls", "part"},
           {"/cam/a.b/part.v2.cls", "part.v2"},
           {"C:\\cam\\part.cls", "part"},
           {".cls", ".cls"},
           {"part", "part"},
           {std::string(100'000, 'p'), std::string(80, 'p')},
           {"cam/", ""}}) {
    const auto job =
        read_parts({.cl = "GOTO/1,2,3", .cl_file_name = file_name, .words = {{"machine", "demo"}}});
    ASSERT_TRUE(job);
    EXPECT_EQ(job->post.default_program_name, name) << file_name;
  }
}

TEST(PlacedInRequest, ANamedMachineHasNoValuesThere) {
  const auto machines = sample::library();
  const Problem problem{
      .code = Code::bad_option, .message = "", .pointer = "/machine/controller/options/arcs"};
  auto job = read(R"({"machine": "demo", "cl": ""})");
  ASSERT_TRUE(job);
  EXPECT_EQ(placed_in_request(problem, *job, machines).pointer, "/machine");

  job = read(R"({"cl": "", "machine": )" + sample::definition_text("mine", "3.0.0") + "}");
  ASSERT_TRUE(job);
  EXPECT_EQ(placed_in_request(problem, *job, machines).pointer, problem.pointer);
}

TEST(JobJson, OffersNearMachinesAndTheVersions) {
  EXPECT_NE(read(R"({"machine": "dmeo", "cl": ""})").error().message.find("demo"),
            std::string::npos);
  EXPECT_NE(read(R"({"machine": "demo@3.0.0", "cl": ""})").error().message.find("1.1.0, 1.0.0"),
            std::string::npos);
}

TEST(JobJson, ShowsLongNamesShortened) {
  const auto job = read(R"({"cl": "", "machine": ")" + std::string(1'000'000, 'm') + "\"}");
  ASSERT_FALSE(job);
  EXPECT_LT(job.error().message.size(), 300u);
}

TEST(JobJson, RefusesDepthBeforeItHurts) {
  const std::string deep(5'000'000, '[');
  EXPECT_EQ(read(deep).error().code, Code::bad_json);
  EXPECT_EQ(read_with("\"setup\": " + deep).error().code, Code::bad_json);
}

TEST(JobWords, SayTheSameAsTheKeys) {
  const auto job = read_parts({.cl = "GOTO/1,2,3",
                               .words = {{"machine", "demo@1.0.0"},
                                         {"output", "axes"},
                                         {"dialect", "heidenhain-iso"},
                                         {"tip_mm", "0.02"},
                                         {"axis_deg", ".1"},
                                         {"cl_units", "inch"},
                                         {"program_name", "P"}}});
  ASSERT_TRUE(job) << job.error().message;

  EXPECT_EQ(job->machine.version, "1.0.0");
  EXPECT_EQ(std::get<jobs::ClText>(job->path).text, "GOTO/1,2,3");
  EXPECT_EQ(std::get<jobs::ClText>(job->path).units, jobs::ClUnits::inch);
  EXPECT_EQ(job->post.output, Output::axes);
  EXPECT_EQ(job->post.dialect, "heidenhain-iso");
  EXPECT_EQ(job->post.program_name, "P");
  EXPECT_EQ(job->tolerances.tip_mm, 0.02);
  EXPECT_EQ(job->tolerances.axis_deg, 0.1);
}

TEST(JobWords, AreRefusedWithThePlaceOfTheirKey) {
  for (const auto& [name, word, code, pointer] :
       std::vector<std::tuple<std::string, std::string, Code, std::string>>{
           {"tip_mm", "0", Code::out_of_domain, "/tolerances/tip_mm"},
           {"tip_mm", "1.001", Code::out_of_domain, "/tolerances/tip_mm"},
           {"axis_deg", "360", Code::out_of_domain, "/tolerances/axis_deg"},
           {"tip_mm", "1e999", Code::out_of_domain, "/tolerances/tip_mm"},
           {"tip_mm", "nan", Code::out_of_domain, "/tolerances/tip_mm"},
           {"axis_deg", "1x", Code::out_of_domain, "/tolerances/axis_deg"},
           {"axis_deg", "", Code::out_of_domain, "/tolerances/axis_deg"},
           {"output", "TCP", Code::out_of_domain, "/post/output"},
           {"dialect", "x", Code::unknown_dialect, "/post/dialect"},
           {"cl_units", "cm", Code::out_of_domain, "/cl_units"},
           {"tolerance", "1", Code::unknown_key, "/tolerance"},
           {"a/b", "1", Code::unknown_key, "/a~1b"},
           {"machine", "demo", Code::conflicting_keys, "/machine"},
       }) {
    SCOPED_TRACE(name + '=' + word);
    const auto job = read_parts({.cl = "", .words = {{"machine", "demo"}, {name, word}}});
    ASSERT_FALSE(job);
    EXPECT_EQ(row_of(job.error().code).name, row_of(code).name);
    EXPECT_EQ(job.error().pointer, pointer);
  }
}

TEST(JobWords, AndTheJobExcludeEachOther) {
  EXPECT_EQ(read_parts({.json = R"({"machine": "demo"})", .cl = "", .words = {{"machine", "demo"}}})
                .error()
                .code,
            Code::conflicting_keys);
  EXPECT_EQ(read_parts({.json = R"({"machine": "demo", "cl": ""})", .cl = ""}).error().code,
            Code::conflicting_keys);
  EXPECT_EQ(read_parts({.json = R"({"machine": "demo", "tolerances": {"tip_mm": 1}})",
                        .cl = "",
                        .words = {{"tip_mm", "1"}}})
                .error()
                .pointer,
            "/tolerances/tip_mm");
}

}  // namespace
}  // namespace pentapost::server

#include "io/picture/population_study_csv.h"

#include "core/valve/number_text.h"
#include "io/picture/csv_lines.h"
#include "search/training/binomial.h"

namespace coapt {
namespace {

const char* group_name(const GroupFindings& group) {
  return group.aetiology ? to_string(*group.aetiology) : "all";
}

class FindingLines {
 public:
  explicit FindingLines(const char* group) : group_(group) {}
  void add_share(CsvLines& csv, const char* table, const std::string& row, int count,
                 int of) const {
    csv << group_ << table << row << count << of;
    if (of > 0) {
      const auto [low, high] = share_interval(count, of);
      csv << static_cast<double>(count) / of << low << high;
    } else {
      csv << ""
          << ""
          << "";
    }
    csv.end_line();
  }
  void add_mean(CsvLines& csv, const char* table, const std::string& row,
                const MeanInterval& interval) const {
    csv << group_ << table << row << interval.count << interval.count << interval.mean
        << interval.low << interval.high;
    csv.end_line();
  }

 private:
  const char* group_;
};

std::string anchor_row(const AnchorComparison& anchor) {
  return std::string(anchor.both_muscles ? "both muscles" : "posteromedial muscle") + " " +
         shown(anchor.movement_mm) + " mm" + (anchor.ring ? ", ring" : "");
}

}  // namespace

std::string population_records_csv(const std::vector<PopulationRecord>& records) {
  std::string header = "index,aetiology";
  for (const EchoFeature& feature : echo_features()) header += std::string(",") + feature.name;
  CsvLines csv(header + ",repair,state,failures,cost,planned_mm2,mean_mm2,sd_mm2");
  for (const PopulationRecord& record : records)
    for (std::size_t c = 0; c < record.candidates.size(); ++c) {
      const CandidateRecord& candidate = record.candidates[c];
      const auto state = static_cast<CandidateState>(candidate.state);
      if (state == CandidateState::NotOffered) continue;
      csv << record.index << to_string(static_cast<Aetiology>(record.aetiology));
      for (const float feature : record.features) csv << static_cast<double>(feature);
      csv << candidate_repairs()[c].name
          << (state == CandidateState::Closed     ? "closed"
              : state == CandidateState::Rejected ? "rejected"
                                                  : "impossible")
          << candidate.failures << static_cast<double>(candidate.cost)
          << static_cast<double>(candidate.planned_mm2) << static_cast<double>(candidate.mean_mm2)
          << static_cast<double>(candidate.sd_mm2);
      csv.end_line();
    }
  return csv.text();
}

std::string population_findings_csv(const PopulationStudy& study) {
  CsvLines csv("group,table,row,count,of,value,low,high");
  for (const GroupFindings& group : study.groups) {
    const FindingLines lines(group_name(group));
    for (const FamilyWins& family : group.families) {
      lines.add_share(csv, "wins", to_string(family.family), family.wins, group.members);
      lines.add_share(csv, "as good as the best", to_string(family.family), family.as_good,
                      group.members);
    }
    for (const CandidateMeans& means : group.candidates) {
      const std::string& name = candidate_repairs()[static_cast<std::size_t>(means.candidate)].name;
      lines.add_share(csv, "at most 5 mm2", name, means.competent, means.closed);
      lines.add_mean(csv, "mean leak mm2", name, means.leak_mm2);
    }
    for (const AnchorComparison& anchor : group.anchors) {
      lines.add_share(csv, "trigone leaks less", anchor_row(anchor), anchor.trigone_better,
                      anchor.members);
      lines.add_share(csv, "trigone leaks the same", anchor_row(anchor), anchor.same,
                      anchor.members);
      lines.add_mean(csv, "trigone less saddle peak mm2", anchor_row(anchor),
                     anchor.difference_mm2);
    }
    for (const DecidedBy& decided : group.decided_by)
      for (std::size_t i = 0; i < decided.indices.total.size(); ++i) {
        csv << group_name(group) << ("Sobol total, " + decided.quantity).c_str()
            << decided.factors[i] << decided.members << decided.members << decided.indices.total[i]
            << ""
            << "";
        csv.end_line();
      }
  }
  return csv.text();
}

}  // namespace coapt

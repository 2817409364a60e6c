#pragma once

#include <QList>
#include <QObject>
#include <QString>

namespace ew::stitching {

class StitchSession;

/// What tests tell a session and ask of it, called by name: a plugin is loaded as a module, and they know none of its types. A child of the
/// stage, found by its own name, "stitchDoor".
class SessionDoor final : public QObject {
  Q_OBJECT

 public:
  SessionDoor(StitchSession& session, QObject* parent);

  Q_INVOKABLE bool openProjectFile(const QString& file);
  Q_INVOKABLE bool saveProjectAs(const QString& file);
  Q_INVOKABLE void saveResultIn(const QString& folder);
  Q_INVOKABLE void setCalibrationFile(int volume, const QString& file);
  Q_INVOKABLE void chooseThePair(int a, int b);
  Q_INVOKABLE QString projectAsText() const;
  Q_INVOKABLE QString verdictOf(int a, int b) const;  ///< "aligned", …; empty: not matched
  Q_INVOKABLE QList<double> transformNow() const;     ///< of the pair, fixed to moving, row by row
  /// Where the pair shows, at a point of the plane's frame, in the fixed volume and in the moving one: six numbers, mm.
  Q_INVOKABLE QList<double> matesAt(double x, double y, double z, bool warped) const;
  Q_INVOKABLE bool isElasticFound() const;
  Q_INVOKABLE QString effortOfWarp() const;
  Q_INVOKABLE double largestWarp_mm() const;
  Q_INVOKABLE int nodesOfResult() const;

 private:
  StitchSession& session_;
};

}  // namespace ew::stitching

"""coapt in 3D Slicer: a segmented mitral valve becomes a closed valve and ranked repair plans beside the echo."""

import json
import os
import tempfile

import ctk
import qt
import slicer
import vtk
from CoaptLib import case, nodes, service
from slicer.ScriptedLoadableModule import (
    ScriptedLoadableModule,
    ScriptedLoadableModuleLogic,
    ScriptedLoadableModuleTest,
    ScriptedLoadableModuleWidget,
)
from slicer.util import VTKObservationMixin

NOTICE = "Research software, not a medical device; not for clinical decisions."
POLL_MS = 50
SETTINGS = (  # key, label, placeholder; the token is not kept
    ("url", "Service", "http://127.0.0.1:8080; empty: one is started"),
    ("token", "Token", "that the service asks for"),
    ("server", "coapt-server", "path; empty: the one of PATH"),
    ("module", "npm package", "folder; for node, where there is no service"),
)


class Coapt(ScriptedLoadableModule):
    def __init__(self, parent):
        super().__init__(parent)
        parent.title = "coapt"
        parent.categories = ["Cardiac"]
        parent.dependencies = ["Segmentations", "Markups", "Sequences"]
        parent.contributors = ["The coapt authors"]
        parent.helpText = (
            "Closes a segmented mitral valve in simulation, measures what leaks, and searches for repairs. "
            f"<b>{NOTICE}</b> docs/engineer/slicer.md of coapt's sources says how."
        )
        parent.acknowledgementText = "Valves of SlicerHeart are read with its terminology, phases and transforms."


class CoaptLogic(ScriptedLoadableModuleLogic):
    """A case and the service of this session. What takes time is steps for a service.Task."""

    def __init__(self):
        super().__init__()
        self.case, self.finder, self.transform = case.Case(), service.Finder(), None

    def take(self, segmentation, annulus=None, tips=None, again=False):
        """Nodes as they are now. Of a valve of SlicerHeart its own annulus and phase count where nothing else is said.

        :param again: they are those of before, so that what was said of them holds
        """
        if segmentation is None:
            raise service.Trouble("Choose a segmentation with the anterior and the posterior leaflet.")
        curve, _, closed = nodes.heart_valve(segmentation)
        annulus = annulus or curve
        files = (
            annulus and case.annulus_file(nodes.read_curve(annulus)),
            tips and case.tips_file(*nodes.read_points(tips)),
        )
        self.case.take(nodes.read_segmentation(segmentation), *files, closed=closed, again=again)
        self.transform = segmentation.GetParentTransformNode()

    def take_file(self, path):
        try:
            with open(path, encoding="utf-8") as file:
                document = json.load(file)
        except (OSError, ValueError) as error:
            raise service.Trouble(f"{os.path.basename(path)} cannot be read: {error}.") from error
        self.case.take_valve(document)
        self.transform = None

    def importing(self):
        return (yield from self.case.importing((yield from self.finder.found())))

    def closing(self, plan=None):
        """Ends with the words for what was shown."""
        shown = yield from self.case.closing((yield from self.finder.found()), plan and plan["plan"])
        nodes.show(shown, f"coapt plan {plan['rank']}" if plan else "coapt", self.transform)
        return shown.words()

    def planning(self, **search):
        return (yield from self.case.planning((yield from self.finder.found()), **search))

    def reporting(self):
        """Ends with the path of a page."""
        page = yield from self.case.reporting((yield from self.finder.found()))
        path = os.path.join(tempfile.mkdtemp(dir=slicer.app.temporaryPath), "coapt-report.html")
        with open(path, "wb") as file:
            file.write(page)
        return path


class CoaptWidget(ScriptedLoadableModuleWidget, VTKObservationMixin):
    def __init__(self, parent=None):
        ScriptedLoadableModuleWidget.__init__(self, parent)
        VTKObservationMixin.__init__(self)

    def setup(self):
        super().setup()
        self.logic, self.task, self.then, self.inputs = CoaptLogic(), None, None, None
        self.layout.addWidget(qt.QLabel(f"<b>{NOTICE}</b>"))
        form = self.section("Service", collapsed=True)
        self.settings = {key: qt.QLineEdit() for key, _, _ in SETTINGS}
        for key, label, placeholder in SETTINGS:
            self.settings[key].placeholderText = placeholder
            self.settings[key].text = "" if key == "token" else qt.QSettings().value(f"Coapt/{key}", "") or ""
            self.settings[key].connect("editingFinished()", self.settingsChanged)
            form.addRow(label, self.settings[key])
        self.settings["token"].echoMode = qt.QLineEdit.Password

        form = self.section("Valve")
        self.segmentation = self.selector(form, "Segmentation", "vtkMRMLSegmentationNode")
        self.annulus = self.selector(form, "Annulus curve", "vtkMRMLMarkupsClosedCurveNode")
        self.tips = self.selector(form, "Papillary tips", "vtkMRMLMarkupsFiducialNode")
        self.image = self.selector(form, "Image", "vtkMRMLScalarVolumeNode")
        self.segmentation.connect(
            "currentNodeChanged(vtkMRMLNode*)", lambda node: self.tried(self.heartValveChosen, node)
        )
        self.evaluations = qt.QSpinBox()
        self.evaluations.setRange(10, 100000)
        self.evaluations.value = 600
        form.addRow("Closures of a search", self.evaluations)
        row = qt.QHBoxLayout()
        pressed = {"Import": self.importValve, "Open ...": self.openValve, "Close": self.close, "Plan": self.plan}
        self.buttons = [self.button(row, *one) for one in {**pressed, "Report": self.report}.items()]
        self.stop = self.button(row, "Cancel", lambda: self.task and self.task.cancel())
        form.addRow(row)
        self.said = qt.QLabel()
        self.said.wordWrap = True
        self.said.textInteractionFlags = qt.Qt.TextSelectableByMouse
        form.addRow(self.said)

        self.controls = self.section("Correct what was judged")
        self.decisions = self.table("Decisions", ("", "of", "decided", "why"))
        self.plans = self.table("Plans (double click: show)", ("rank", "steps", "leak", "cost", "remarks"))
        self.plans.connect("cellDoubleClicked(int,int)", lambda row, _: self.close(self.logic.case.plans[row]))
        self.layout.addStretch(1)

        self.timer = qt.QTimer()
        self.timer.setInterval(POLL_MS)
        self.timer.connect("timeout()", self.poll)
        self.addObserver(slicer.mrmlScene, slicer.mrmlScene.EndCloseEvent, self.sceneClosed)
        self.settingsChanged()
        self.refresh()

    def cleanup(self):
        self.timer.stop()
        self.removeObservers()
        self.logic.finder.stop()

    # What the panel is made of.

    def section(self, title, collapsed=False):
        group = ctk.ctkCollapsibleButton()
        group.text, group.collapsed = title, collapsed
        self.layout.addWidget(group)
        return qt.QFormLayout(group)

    def selector(self, form, label, kind):
        box = slicer.qMRMLNodeComboBox()
        box.nodeTypes = [kind]
        box.addEnabled = box.removeEnabled = box.renameEnabled = False
        box.noneEnabled = True
        box.setMRMLScene(slicer.mrmlScene)
        box.setCurrentNode(None)
        form.addRow(label, box)
        return box

    def button(self, row, text, pressed):
        button = qt.QPushButton(text)
        button.connect("clicked()", pressed)
        row.addWidget(button)
        return button

    def table(self, title, columns):
        table = qt.QTableWidget()
        table.setColumnCount(len(columns))
        table.setHorizontalHeaderLabels(columns)
        table.setEditTriggers(qt.QAbstractItemView.NoEditTriggers)
        table.horizontalHeader().setStretchLastSection(True)
        self.section(title).addRow(table)
        return table

    def fill(self, table, rows):
        table.setRowCount(len(rows))
        for i, row in enumerate(rows):
            for k, text in enumerate(row):
                item = qt.QTableWidgetItem(text)
                item.setToolTip(text)
                table.setItem(i, k, item)
        table.resizeColumnsToContents()

    # What is under way: one task, which a timer asks.

    def run(self, steps, then):
        if self.task is None:
            self.task, self.then = service.Task(steps), then
            self.timer.start()
            self.refresh()

    def poll(self):
        ended = True
        try:
            ended = self.task.poll()
            self.said.text = str(self.task.error or self.task.said)
            if ended and not self.task.error:
                self.said.text = self.then(self.task.result) or ""
        except service.Trouble as trouble:
            self.said.text = str(trouble)
        finally:
            if ended:
                self.timer.stop()
                self.task = None
                self.refresh()

    def refresh(self):
        for button in self.buttons:
            button.enabled = self.task is None
        self.stop.enabled = self.task is not None
        self.fill(self.decisions, [("check" if look else "", *texts) for *texts, look in self.logic.case.decisions()])
        self.fill(self.plans, self.logic.case.rows())
        while self.controls.rowCount():
            self.controls.removeRow(0)
        for control in self.logic.case.controls():
            choice = qt.QComboBox()
            values = [value for _, value in control.options]
            choice.addItems([text for text, _ in control.options])
            choice.currentIndex = values.index(control.value) if control.value in values else 0
            choice.connect("activated(int)", lambda i, key=control.key, values=values: self.correct(key, values[i]))
            self.controls.addRow(control.text, choice)

    # What is pressed and chosen.

    def tried(self, act, *inputs, **named):
        """Whether it went well."""
        try:
            act(*inputs, **named)
        except service.Trouble as trouble:
            self.said.text = str(trouble)
            return False
        return True

    def settingsChanged(self):
        settings = {key: edit.text for key, edit in self.settings.items()}
        finder = service.Finder(settings)
        if finder.settings != self.logic.finder.settings:
            for key in set(settings) - {"token"}:
                qt.QSettings().setValue(f"Coapt/{key}", settings[key])
            self.logic.finder.stop()
            self.logic.finder = finder

    def heartValveChosen(self, node):
        curve, volume, _ = nodes.heart_valve(node) if node else (None, None, None)
        self.annulus.setCurrentNode(curve)
        self.image.setCurrentNode(volume)

    def importValve(self):
        inputs = [box.currentNode() for box in (self.segmentation, self.annulus, self.tips)]
        if self.tried(self.logic.take, *inputs, again=inputs == self.inputs):
            self.inputs = inputs
            self.run(self.logic.importing(), self.imported)

    def correct(self, key, value):
        self.logic.case.say(key, value)
        qt.QTimer.singleShot(0, self.importValve)  # which makes the controls anew: not while one of them is speaking

    def imported(self, result):
        looks = sum(look for *_, look in self.logic.case.decisions())
        return f"{result['triangles']} triangles, {result['chordae']} chordae; decisions to check: {looks}."

    def openValve(self):
        path = qt.QFileDialog.getOpenFileName(None, "Valve of coapt", "", "Valves (*.json)")
        if path and self.tried(self.logic.take_file, path):
            self.said.text, self.inputs = os.path.basename(path), None
            self.refresh()

    def close(self, plan=None):
        if self.image.currentNode():
            slicer.util.setSliceViewerLayers(background=self.image.currentNode())
        self.run(self.logic.closing(plan), lambda words: words)

    def plan(self):
        self.run(self.logic.planning(evaluations=self.evaluations.value), lambda plans: f"Plans: {len(plans)}.")

    def report(self):
        self.run(self.logic.reporting(), lambda path: qt.QDesktopServices.openUrl(qt.QUrl.fromLocalFile(path)) and path)

    def sceneClosed(self, caller=None, event=None):
        self.logic.case, self.inputs = case.Case(), None
        self.refresh()


class CoaptTest(ScriptedLoadableModuleTest):
    """Needs a coapt-server in PATH, or COAPT_SERVER."""

    def setUp(self):
        slicer.mrmlScene.Clear()

    def runTest(self):
        self.setUp()
        self.test_segmentation_below_a_transform_becomes_plans()

    def test_segmentation_below_a_transform_becomes_plans(self):
        logic = CoaptLogic()
        try:
            self.delayDisplay("A preset as a segmentation, below a transform as SlicerHeart has it")
            found = self.waited(logic.finder.found())
            answer = self.waited(self.exported(found))
            segmentation = nodes.Folder("input", None).label_map(answer.body)
            transform = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLLinearTransformNode", "ProbeToRAS")
            turn = vtk.vtkTransform()
            turn.RotateX(30)
            turn.Translate(10, -20, 30)
            transform.SetMatrixTransformToParent(turn.GetMatrix())
            segmentation.SetAndObserveTransformNodeID(transform.GetID())

            self.delayDisplay("Import, close, plan")
            logic.take(segmentation)
            self.waited(logic.importing())
            self.assertTrue(logic.case.decisions())
            self.assertIn("Leak", self.waited(logic.closing()))
            plans = self.waited(logic.planning(evaluations=20, plans=1, region_points=5, model_draws=0, evidence=False))
            self.waited(logic.closing(plans[0]))

            model = slicer.util.getNode("coapt: leaflets")
            self.assertEqual(model.GetParentTransformNode(), transform)
            self.assertIsNotNone(model.GetPolyData().GetCellData().GetArray("strain_circumferential"))
            drawn, given = [0.0] * 6, [0.0] * 6
            model.GetRASBounds(drawn)
            segmentation.GetRASBounds(given)
            for k in range(0, 4):  # the leaflets close, but do not leave the annulus
                self.assertLess(abs(drawn[k] - given[k]), 15)
            self.assertEqual(slicer.util.getNode("coapt: annulus").GetParentTransformNode(), transform)
            self.assertIsNotNone(slicer.util.getNode("coapt plan 1: label map"))
            self.assertGreater(slicer.util.getNode("coapt: closing").GetNumberOfDataNodes(), 10)
            self.delayDisplay("Test passed")
        finally:
            logic.finder.stop()

    @staticmethod
    def exported(found):
        return (
            yield found.ask("POST", "/v1/exports", {"valve": "human-functional-mr", "format": "nrrd", "open": True})
        )

    @staticmethod
    def waited(steps):
        return service.waited(steps, slicer.app.processEvents)

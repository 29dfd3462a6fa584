#!/usr/bin/env python3
"""write_image_files.py FOLDER: one label map as nibabel, VTK and teem's unu write it, and a DICOM series of its images as
pydicom does, with names and numbers of a patient, which coapt must not repeat.

Voxel (i, j, k) of 6 x 5 x 4 has label (i + 2 j + 3 k) mod 4; its centre is ORIGIN + AXES (i, j, k) in LPS mm. The files are
committed in tests/io/image/files; packages: python3-nibabel python3-pydicom python3-vtk9 teem-apps (group readers)."""

import subprocess
import sys
from pathlib import Path

import nibabel
import numpy
import pydicom
import vtk
from pydicom.dataset import FileDataset, FileMetaDataset
from pydicom.uid import ExplicitVRLittleEndian, ImplicitVRLittleEndian, generate_uid
from vtk.util.numpy_support import numpy_to_vtk

SIZE = (6, 5, 4)
# A right-handed frame turned by 30 degrees about z, then by 20 about x; edges 0.5, 0.6 and 0.8 mm.
Z, X = numpy.radians(30), numpy.radians(20)
TURN = numpy.array([[1, 0, 0], [0, numpy.cos(X), -numpy.sin(X)], [0, numpy.sin(X), numpy.cos(X)]]) @ numpy.array(
    [[numpy.cos(Z), -numpy.sin(Z), 0], [numpy.sin(Z), numpy.cos(Z), 0], [0, 0, 1]]
)
AXES = TURN * numpy.array([0.5, 0.6, 0.8])
ORIGIN = numpy.array([12.5, -40.25, 310.0])
I, J, K = numpy.indices(SIZE)
LABELS = (I + 2 * J + 3 * K) % 4

LPS = numpy.eye(4)
LPS[:3, :3] = AXES
LPS[:3, 3] = ORIGIN
RAS = numpy.diag([-1.0, -1.0, 1.0, 1.0]) @ LPS


def nibabel_files(folder):
    for name, kind, dtype, frames in [
        ("sform.nii.gz", nibabel.Nifti1Image, "<u1", (1, 0)),
        ("qform.nii", nibabel.Nifti1Image, "<i2", (0, 1)),
        ("big-endian.nii", nibabel.Nifti1Image, ">i4", (1, 1)),
        ("nifti-2.nii.gz", nibabel.Nifti2Image, "<u2", (1, 0)),
        ("real-numbers.nii.gz", nibabel.Nifti1Image, "<f8", (1, 0)),
        ("no-frame.nii.gz", nibabel.Nifti1Image, "<u1", (0, 0)),
    ]:
        header = kind.header_class(endianness=dtype[0])
        header.set_data_dtype(dtype)
        header["descrip"] = b"DOE^JANE 1948"
        image = kind(LABELS.astype(dtype), RAS, header)
        image.set_sform(RAS, frames[0])
        image.set_qform(RAS, frames[1])
        if frames == (0, 0):
            image.header.set_zooms((0.5, 0.6, 0.8))
        nibabel.save(image, folder / name)


def vtk_file(folder):
    image = vtk.vtkImageData()
    image.SetDimensions(*SIZE)
    image.SetSpacing(0.5, 0.6, 0.8)
    image.GetPointData().SetScalars(numpy_to_vtk(LABELS.ravel(order="F").astype(numpy.uint8), deep=True))
    frame = vtk.vtkMatrix4x4()
    turn = numpy.diag([-1.0, -1.0, 1.0]) @ TURN
    for row in range(3):
        for column in range(3):
            frame.SetElement(row, column, turn[row, column])
        frame.SetElement(row, 3, RAS[row, 3])
    writer = vtk.vtkNIFTIImageWriter()
    writer.SetInputData(image)
    writer.SetQFormMatrix(frame)
    writer.SetFileName(str(folder / "vtk.nii.gz"))
    writer.Write()


def unu_files(folder):
    """Made from a bare file by `unu make`, then saved in each encoding."""
    bare = folder / "bare.raw"
    bare.write_bytes(LABELS.ravel(order="F").astype("<u2").tobytes())

    def vector(numbers):
        return "(" + ",".join(f"{number:.17g}" for number in numbers) + ")"

    unu = ["teem-unu", "make", "-i", bare, "-t", "ushort", "-s", *map(str, SIZE), "-e", "raw", "-en", "little"]
    placed = ["-spc", "left-posterior-superior", "-orig", vector(ORIGIN), "-dirs", " ".join(map(vector, AXES.T))]
    made = folder / "made.nrrd"
    subprocess.run([*unu, *placed, "-o", made], check=True)
    for name, options in [
        ("raw.nrrd", ["-e", "raw", "-en", "big"]),
        ("gzip.nrrd", ["-e", "gzip"]),
        ("ascii.nrrd", ["-e", "text"]),
    ]:
        subprocess.run(["teem-unu", "save", "-f", "nrrd", *options, "-i", made, "-o", folder / name], check=True)
    subprocess.run([*unu, "-sp", "0.5", "0.6", "0.8", "-o", folder / "no-frame.nrrd"], check=True)
    bare.unlink()
    made.unlink()


def dicom_slice(path, number, placed=True):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
    meta.MediaStorageSOPInstanceUID = generate_uid(entropy_srcs=[str(path), str(number)])
    meta.TransferSyntaxUID = ExplicitVRLittleEndian if number % 2 else ImplicitVRLittleEndian
    data = FileDataset(str(path), {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian, data.is_implicit_VR = True, number % 2 == 0
    data.SOPClassUID, data.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
    data.PatientName, data.PatientID, data.PatientBirthDate = "DOE^JANE", "MRN-4711", "19480229"
    data.InstitutionName, data.SeriesInstanceUID = "Saint Elsewhere", "1.2.3.4711"
    data.Rows, data.Columns = SIZE[1], SIZE[0]
    data.PixelSpacing = [0.6, 0.5]
    data.SliceThickness = 0.8
    data.InstanceNumber = number + 1
    if placed:
        data.ImageOrientationPatient = [float(f"{x:.12f}") for x in [*TURN[:, 0], *TURN[:, 1]]]
        data.ImagePositionPatient = [float(f"{x:.12f}") for x in ORIGIN + number * AXES[:, 2]]
    data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
    data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = 16, 16, 15, 0
    data.PixelData = bytes(2 * SIZE[0] * SIZE[1])
    data.save_as(path, write_like_original=False)


def dicom_files(folder):
    (folder / "series").mkdir(exist_ok=True)
    (folder / "series-without-orientation").mkdir(exist_ok=True)
    for number in range(SIZE[2]):
        # The order of the names is not that of the slices.
        dicom_slice(folder / "series" / f"{(3 * number + 1) % SIZE[2]}.dcm", number)
        dicom_slice(folder / "series-without-orientation" / f"{number}.dcm", number, placed=False)


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(exist_ok=True)
    nibabel_files(folder)
    vtk_file(folder)
    unu_files(folder)
    dicom_files(folder)
    assert pydicom.dcmread(folder / "series" / "0.dcm").Rows == SIZE[1]


if __name__ == "__main__":
    main()

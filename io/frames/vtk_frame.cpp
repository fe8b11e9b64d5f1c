#include "io/frames/vtk_frame.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "solver/base/failure.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <string_view>

namespace quicksand {

namespace {

constexpr const char* time_array = "TimeValue";
constexpr const char* units_array = "units";

/// Keeps VTK from printing its own messages; ours say more.
class QuietVtk {
public:
    QuietVtk() : displayed_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
    ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(displayed_); }
    QuietVtk(const QuietVtk&) = delete;
    QuietVtk& operator=(const QuietVtk&) = delete;

private:
    int displayed_;
};

template <class Array, class Value>
void add_values(const FrameArray& source, const std::vector<Value>& values, vtkFieldData& target)
{
    const std::size_t components = source.component_count();
    vtkNew<Array> array;
    array->SetName(source.name.c_str());
    array->SetNumberOfComponents(static_cast<int>(components));
    for (std::size_t c = 0; c < source.components.size(); ++c)
        array->SetComponentName(static_cast<vtkIdType>(c), source.components[c].c_str());
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / components));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    target.AddArray(array);
}

void add_array(const FrameArray& source, vtkFieldData& target)
{
    if (const auto* singles = std::get_if<std::vector<float>>(&source.values))
        add_values<vtkFloatArray>(source, *singles, target);
    else if (const auto* doubles = std::get_if<std::vector<double>>(&source.values))
        add_values<vtkDoubleArray>(source, *doubles, target);
    else
        add_values<vtkIntArray>(source, std::get<std::vector<std::int32_t>>(source.values), target);
}

void add_text(const FrameText& text, vtkFieldData& target)
{
    vtkNew<vtkStringArray> array;
    array->SetName(text.name.c_str());
    for (const std::string& line : text.lines) array->InsertNextValue(line);
    target.AddArray(array);
}

void add_time(double time, vtkFieldData& target)
{
    vtkNew<vtkDoubleArray> array;
    array->SetName(time_array);
    array->InsertNextValue(time);
    target.AddArray(array);
}

FrameText units_text(const Frame& frame)
{
    FrameText text{units_array, {std::string(time_array) + ": s"}};
    for (const auto* arrays : {&frame.point_data, &frame.cell_data})
        for (const FrameArray& array : *arrays) text.lines.push_back(array.name + ": " + array.unit);
    return text;
}

vtkSmartPointer<vtkIdTypeArray> numbers(const std::vector<std::int64_t>& values)
{
    const auto array = vtkSmartPointer<vtkIdTypeArray>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

void fill_geometry(const Frame& frame, vtkUnstructuredGrid& grid)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(frame.points.size()));
    for (std::size_t k = 0; k < frame.points.size(); ++k)
        points->SetPoint(static_cast<vtkIdType>(k), frame.points[k].x(), frame.points[k].y(), 0.0);

    vtkNew<vtkUnsignedCharArray> types;
    types->SetNumberOfValues(static_cast<vtkIdType>(frame.cells.size()));
    for (std::size_t c = 0; c < frame.cells.size(); ++c)
        types->SetValue(static_cast<vtkIdType>(c), frame.cells[c].size() == 4 ? VTK_QUAD : VTK_POLYGON);
    vtkNew<vtkCellArray> cells;
    cells->SetData(numbers(frame.cells.starts), numbers(frame.cells.corners));

    grid.SetPoints(points);
    grid.SetCells(types, cells);
}

std::vector<std::string> component_names(vtkAbstractArray& array)
{
    std::vector<std::string> names;
    if (array.GetNumberOfComponents() == 1) return names;
    for (int c = 0; c < array.GetNumberOfComponents(); ++c) {
        const char* name = array.GetComponentName(c);
        names.emplace_back(name ? name : std::to_string(c));
    }
    return names;
}

std::vector<FrameArray> read_arrays(vtkFieldData& source)
{
    std::vector<FrameArray> arrays;
    for (int k = 0; k < source.GetNumberOfArrays(); ++k) {
        vtkDataArray* array = source.GetArray(k);
        if (!array || !array->GetName()) continue;
        FrameArray target{array->GetName(), "-", component_names(*array), {}};
        const vtkIdType count = array->GetNumberOfValues();
        if (auto* singles = vtkFloatArray::SafeDownCast(array))
            target.values = std::vector<float>(singles->GetPointer(0), singles->GetPointer(0) + count);
        else if (auto* doubles = vtkDoubleArray::SafeDownCast(array))
            target.values = std::vector<double>(doubles->GetPointer(0), doubles->GetPointer(0) + count);
        else if (auto* integers = vtkIntArray::SafeDownCast(array))
            target.values =
                std::vector<std::int32_t>(integers->GetPointer(0), integers->GetPointer(0) + count);
        else
            continue;
        arrays.push_back(std::move(target));
    }
    return arrays;
}

void read_geometry(vtkUnstructuredGrid& grid, Frame& frame)
{
    for (vtkIdType k = 0; k < grid.GetNumberOfPoints(); ++k) {
        const double* point = grid.GetPoint(k);
        frame.points.emplace_back(point[0], point[1]);
    }
    for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        grid.GetCellPoints(c, count, corners);
        frame.cells.add(std::vector<std::int64_t>(corners, corners + count));
    }
}

/// Lines "name: unit" back to the arrays.
void set_units(const std::vector<std::string>& lines, std::vector<FrameArray>& arrays)
{
    for (FrameArray& array : arrays)
        for (const std::string& line : lines)
            if (line.starts_with(array.name + ": ")) array.unit = line.substr(array.name.size() + 2);
}

void read_field_data(vtkFieldData& fields, Frame& frame)
{
    if (vtkDataArray* time = fields.GetArray(time_array); time && time->GetNumberOfTuples() > 0)
        frame.time = time->GetTuple1(0);
    for (int k = 0; k < fields.GetNumberOfArrays(); ++k) {
        auto* lines = vtkStringArray::SafeDownCast(fields.GetAbstractArray(k));
        if (!lines || !lines->GetName()) continue;
        FrameText text{lines->GetName(), {}};
        for (vtkIdType line = 0; line < lines->GetNumberOfValues(); ++line)
            text.lines.push_back(lines->GetValue(line));
        if (text.name == units_array) {
            set_units(text.lines, frame.point_data);
            set_units(text.lines, frame.cell_data);
        } else {
            frame.texts.push_back(std::move(text));
        }
    }
}

} // namespace

void write_frame(const std::filesystem::path& path, const Frame& frame)
{
    const QuietVtk quiet;
    vtkNew<vtkUnstructuredGrid> grid;
    fill_geometry(frame, *grid);
    for (const FrameArray& array : frame.point_data) add_array(array, *grid->GetPointData());
    for (const FrameArray& array : frame.cell_data) add_array(array, *grid->GetCellData());
    add_time(frame.time, *grid->GetFieldData());
    add_text(units_text(frame), *grid->GetFieldData());
    for (const FrameText& text : frame.texts) add_text(text, *grid->GetFieldData());

    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    // Arrays in place are a third larger than appended, but XML throughout: Debian's ParaView 5.11 with the
    // expat of today, which puts off a tag that comes in pieces, reads on into appended data.
    writer->SetDataModeToBinary();
    writer->SetCompressorTypeToZLib();
    // Higher levels cost time and save two per cent.
    writer->SetCompressionLevel(1);
    // By way of memory, for VTK 9.1 crashes on a disk that is full.
    writer->WriteToOutputStringOn();
    ENSURE(writer->Write() == 1);
    write_durably(path, writer->GetOutputString());
}

Frame read_frame(const std::filesystem::path& path)
{
    const QuietVtk quiet;
    if (!std::filesystem::exists(path)) throw FileError(path, "cannot read the frame", "no such file", "");
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkUnstructuredGrid* grid = reader->GetOutput();
    if (reader->GetErrorCode() != vtkErrorCode::NoError || !grid ||
        !grid->GetFieldData()->GetArray(time_array))
        throw FileError(path, "cannot read the frame", "it is damaged or not written by Quicksand", "");
    Frame frame;
    read_geometry(*grid, frame);
    frame.point_data = read_arrays(*grid->GetPointData());
    frame.cell_data = read_arrays(*grid->GetCellData());
    read_field_data(*grid->GetFieldData(), frame);
    return frame;
}

} // namespace quicksand

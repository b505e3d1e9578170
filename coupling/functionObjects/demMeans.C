/*---------------------------------------------------------------------------*\
    demMeans.C -- time means of fields by blocks, with their confidence intervals.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demMeans.H"
#include "demFiles.H"
#include "demCheck.H"
#include "dem_tables.h"
#include "volFields.H"
#include "zeroGradientFvPatchField.H"
#include "mapPolyMesh.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(demMeans, 0);
    addToRunTimeSelectionTable(functionObject, demMeans, dictionary);
}
}

namespace Foam
{

template<class Type>
class typedSeries
:
    public functionObjects::demMeans::series
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    const fvMesh& mesh_;
    const word name_;

    //- A column of the core's block means for each component of each cell
    ::dem_means* means_;

    // The components of a field are consecutive numbers
    static const scalar* data(const Field<Type>& values)
    {
        return reinterpret_cast<const scalar*>(values.cdata());
    }

    void write(const word& ending, const Field<Type>& values) const
    {
        const fieldType& field = mesh_.lookupObject<fieldType>(name_);
        fieldType result
        (
            demFileAt(mesh_.time().timeName(), name_ + ending, mesh_, IOobject::NO_READ),
            mesh_,
            dimensioned<Type>(field.dimensions(), Zero),
            zeroGradientFvPatchField<Type>::typeName
        );

        result.primitiveFieldRef() = values;
        result.correctBoundaryConditions();
        result.write();
    }


public:

    typedSeries(const fvMesh& mesh, const word& name)
    :
        mesh_(mesh),
        name_(name),
        means_(nullptr)
    {
        demCheck
        (
            dem_means_create
            (
                &means_,
                mesh.nCells()*pTraits<Type>::nComponents
            )
        );
    }


    virtual ~typedSeries()
    {
        dem_means_free(means_);
    }


    virtual void add(const scalar weight)
    {
        dem_means_add
        (
            means_,
            data(mesh_.lookupObject<fieldType>(name_).primitiveField()),
            weight
        );
    }


    //- The mean includes all samples, also of the present block
    virtual label write() const
    {
        Field<Type> mean(mesh_.nCells()), interval(mesh_.nCells());
        const label blocks = dem_means_get
        (
            means_,
            const_cast<scalar*>(data(mean)),
            const_cast<scalar*>(data(interval))
        );

        write("BlockMean", mean);
        if (blocks >= DEM_MEANS_MIN_BLOCKS)
        {
            write("Interval", interval);
        }
        return blocks;
    }
};

} // End namespace Foam


void Foam::functionObjects::demMeans::begin()
{
    series_.clear();
    duration_ = 0;
}


template<class Type>
bool Foam::functionObjects::demMeans::addSeries(const word& field)
{
    if (!mesh_.foundObject<GeometricField<Type, fvPatchField, volMesh>>(field))
    {
        return false;
    }
    series_.append(new typedSeries<Type>(mesh_, field));
    return true;
}


Foam::functionObjects::demMeans::demMeans
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
    begin();
}


bool Foam::functionObjects::demMeans::read(const dictionary& dict)
{
    dict.readEntry("fields", fields_);
    ownTimes_ =
        dict.found("writeControl")
     || dict.found("outputControl")
     || dict.found("writeInterval");
    return fvMeshFunctionObject::read(dict);
}


bool Foam::functionObjects::demMeans::execute()
{
    // A few written times are no means of the run, which stay as they are
    if (postProcess)
    {
        return true;
    }

    // Fields may be constructed after this object
    for (label i = series_.size(); i < fields_.size(); i++)
    {
        const word& field = fields_[i];
        const bool found =
            addSeries<scalar>(field)
         || addSeries<vector>(field)
         || addSeries<sphericalTensor>(field)
         || addSeries<symmTensor>(field)
         || addSeries<tensor>(field);

        if (!found)
        {
            FatalErrorInFunction
                << "functions/" << name() << ": there is no field " << field
                << " in cells. Fields there are: "
                << flatOutput(mesh_.sortedNames<volScalarField>()) << ' '
                << flatOutput(mesh_.sortedNames<volVectorField>()) << ' '
                << flatOutput(mesh_.sortedNames<volSymmTensorField>())
                << ". Fields of particles are asked for by coupling/fields in"
                << " constant/demProperties" << exit(FatalError);
        }
    }

    forAll(series_, i)
    {
        series_[i].add(time_.deltaTValue());
    }
    duration_ += time_.deltaTValue();
    return true;
}


bool Foam::functionObjects::demMeans::write()
{
    // Without a writeControl OpenFOAM calls this in every step
    if (series_.empty() || !(ownTimes_ || time_.writeTime()))
    {
        return true;
    }

    label blocks = 0;
    forAll(series_, i)
    {
        blocks = series_[i].write();
    }
    Log << type() << ' ' << name() << ": means over " << duration_
        << " s in " << blocks << " blocks";
    if (blocks < DEM_MEANS_MIN_BLOCKS)
    {
        Log << ", too few for an interval: it needs "
            << label(DEM_MEANS_MIN_BLOCKS);
    }
    Log << nl << endl;
    return true;
}


void Foam::functionObjects::demMeans::updateMesh(const mapPolyMesh& map)
{
    if (&map.mesh() == &mesh_)
    {
        Log << type() << ' ' << name() << ": the mesh changes, means start anew"
            << nl << endl;
        begin();
    }
}

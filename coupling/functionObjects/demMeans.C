/*---------------------------------------------------------------------------*\
    demMeans.C -- time means of fields by blocks, with their confidence intervals.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demMeans.H"
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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const label maxBlocks = 32;
static const label minBlocks = 4;

// 97.5 % quantile of Student's distribution for n degrees of freedom, within 1 %
// from n = 3 on: Abramowitz and Stegun, Handbook of Mathematical Functions (1964),
// 26.7.5
static scalar studentQuantile(const scalar n)
{
    const scalar z = 1.959964, z2 = z*z;

    return z*
    (
        1
      + (z2 + 1)/(4*n)
      + ((5*z2 + 16)*z2 + 3)/(96*sqr(n))
      + (((3*z2 + 19)*z2 + 17)*z2 - 15)/(384*pow3(n))
    );
}


template<class Type>
class typedSeries
:
    public functionObjects::demMeans::series
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    const fvMesh& mesh_;
    const word name_;

    //- Sum of values times weights, of each block
    List<Field<Type>> sums_;

    void write(const word& ending, const Field<Type>& values) const
    {
        const fieldType& field = mesh_.lookupObject<fieldType>(name_);
        fieldType result
        (
            IOobject
            (
                name_ + ending,
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
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
        sums_(maxBlocks, Field<Type>(mesh.nCells(), Zero))
    {}


    virtual void add(const label block, const scalar weight)
    {
        sums_[block] +=
            weight*mesh_.lookupObject<fieldType>(name_).primitiveField();
    }


    virtual void merge()
    {
        for (label k = 0; k < maxBlocks/2; k++)
        {
            sums_[k] = sums_[2*k] + sums_[2*k + 1];
        }
        for (label k = maxBlocks/2; k < maxBlocks; k++)
        {
            sums_[k] = Zero;
        }
    }


    //- The mean is that of all samples, those of the present block included
    virtual void write(const UList<scalar>& weights) const
    {
        const label n = weights.size() - 1;
        const scalar all = sum(weights), ofFull = all - weights[n];

        Field<Type> total(mesh_.nCells(), Zero), full(total), square(total);
        for (label k = 0; k <= n; k++)
        {
            total += sums_[k];
        }
        write("BlockMean", total/all);

        if (n < minBlocks)
        {
            return;
        }

        full = (total - sums_[n])/ofFull;
        for (label k = 0; k < n; k++)
        {
            const Field<Type> off(sums_[k]/weights[k] - full);
            square += weights[k]*cmptMultiply(off, off);
        }
        square /= ofFull*(n - 1);

        for (direction d = 0; d < pTraits<Type>::nComponents; d++)
        {
            full.replace(d, studentQuantile(n - 1)*sqrt(square.component(d)));
        }
        write("Interval", full);
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::demMeans::begin()
{
    series_.clear();
    weights_.setSize(maxBlocks);
    weights_ = Zero;
    fullBlocks_ = samples_ = 0;
    samplesPerBlock_ = 1;
}


void Foam::functionObjects::demMeans::merge()
{
    forAll(series_, i)
    {
        series_[i].merge();
    }
    for (label k = 0; k < maxBlocks/2; k++)
    {
        weights_[k] = weights_[2*k] + weights_[2*k + 1];
    }
    for (label k = maxBlocks/2; k < maxBlocks; k++)
    {
        weights_[k] = 0;
    }
    fullBlocks_ = maxBlocks/2;
    samplesPerBlock_ *= 2;
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


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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

    const scalar weight = time_.deltaTValue();
    forAll(series_, i)
    {
        series_[i].add(fullBlocks_, weight);
    }
    weights_[fullBlocks_] += weight;

    if (++samples_ == samplesPerBlock_)
    {
        samples_ = 0;
        if (++fullBlocks_ == maxBlocks)
        {
            merge();
        }
    }
    return true;
}


bool Foam::functionObjects::demMeans::write()
{
    // Without a writeControl OpenFOAM calls this in every step
    if (series_.empty() || !(ownTimes_ || time_.writeTime()))
    {
        return true;
    }

    Log << type() << ' ' << name() << ": means over " << sum(weights_)
        << " s in " << fullBlocks_ << " blocks";
    if (fullBlocks_ < minBlocks)
    {
        Log << ", too few for an interval: it needs " << minBlocks;
    }
    Log << nl << endl;

    const SubList<scalar> used(weights_, fullBlocks_ + 1);
    forAll(series_, i)
    {
        series_[i].write(used);
    }
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

// ************************************************************************* //

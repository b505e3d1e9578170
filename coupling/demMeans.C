/*---------------------------------------------------------------------------*\
    demMeans.C -- means of fields over time, and how sure they are.

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

static const label most = 32;
static const label least = 4;

// 97.5 % of Student's distribution, within 1 % from n = 3 on: Abramowitz and
// Stegun, Handbook of Mathematical Functions (1964), 26.7.5
static scalar student(const scalar n)
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
class seriesOf
:
    public functionObjects::demMeans::series
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    const fvMesh& mesh_;
    const word name_;

    //- Values times weights, of each block
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

    seriesOf(const fvMesh& mesh, const word& name)
    :
        mesh_(mesh),
        name_(name),
        sums_(most, Field<Type>(mesh.nCells(), Zero))
    {}


    virtual void add(const label block, const scalar weight)
    {
        sums_[block] +=
            weight*mesh_.lookupObject<fieldType>(name_).primitiveField();
    }


    virtual void merge()
    {
        for (label k = 0; k < most/2; k++)
        {
            sums_[k] = sums_[2*k] + sums_[2*k + 1];
        }
        for (label k = most/2; k < most; k++)
        {
            sums_[k] = Zero;
        }
    }


    //- The mean is that of all samples, the block that is being filled included
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

        if (n < least)
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
            full.replace(d, student(n - 1)*sqrt(square.component(d)));
        }
        write("Interval", full);
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::demMeans::begin()
{
    series_.clear();
    weights_.setSize(most);
    weights_ = Zero;
    full_ = inside_ = 0;
    length_ = 1;
}


void Foam::functionObjects::demMeans::merge()
{
    forAll(series_, i)
    {
        series_[i].merge();
    }
    for (label k = 0; k < most/2; k++)
    {
        weights_[k] = weights_[2*k] + weights_[2*k + 1];
    }
    for (label k = most/2; k < most; k++)
    {
        weights_[k] = 0;
    }
    full_ = most/2;
    length_ *= 2;
}


template<class Type>
bool Foam::functionObjects::demMeans::take(const word& field)
{
    if (!mesh_.foundObject<GeometricField<Type, fvPatchField, volMesh>>(field))
    {
        return false;
    }
    series_.append(new seriesOf<Type>(mesh_, field));
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
    // Fields may be made after this object
    for (label i = series_.size(); i < fields_.size(); i++)
    {
        const word& field = fields_[i];
        const bool found =
            take<scalar>(field)
         || take<vector>(field)
         || take<sphericalTensor>(field)
         || take<symmTensor>(field)
         || take<tensor>(field);

        if (!found)
        {
            FatalErrorInFunction
                << "functions/" << name() << ": there is no field " << field
                << " in cells; there are "
                << flatOutput(mesh_.sortedNames<volScalarField>()) << ' '
                << flatOutput(mesh_.sortedNames<volVectorField>()) << ' '
                << flatOutput(mesh_.sortedNames<volSymmTensorField>())
                << ". Fields of particles are kept with coupling/fields in"
                << " constant/demProperties" << exit(FatalError);
        }
    }

    const scalar weight = time_.deltaTValue();
    forAll(series_, i)
    {
        series_[i].add(full_, weight);
    }
    weights_[full_] += weight;

    if (++inside_ == length_)
    {
        inside_ = 0;
        if (++full_ == most)
        {
            merge();
        }
    }
    return true;
}


bool Foam::functionObjects::demMeans::write()
{
    // Without a writeControl OpenFOAM asks in every step
    if (series_.empty() || !(ownTimes_ || time_.writeTime()))
    {
        return true;
    }

    Log << type() << ' ' << name() << ": means over " << sum(weights_)
        << " s in " << full_ << " blocks";
    if (full_ < least)
    {
        Log << ", too few for an interval: it needs " << least;
    }
    Log << nl << endl;

    const SubList<scalar> used(weights_, full_ + 1);
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
        Log << type() << ' ' << name() << ": the mesh changes, means begin anew"
            << nl << endl;
        begin();
    }
}

// ************************************************************************* //

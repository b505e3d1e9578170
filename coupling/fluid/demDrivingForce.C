/*---------------------------------------------------------------------------*\
    demDrivingForce.C -- the pressure gradient that drives a periodic flow.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDrivingForce.H"
#include "demFiles.H"
#include "fvMatrices.H"
#include "fvOptions.H"
#include "meanVelocityForce.H"

namespace Foam
{

// addSup of an option is not const
static fv::optionList* optionsOf(const fvMesh& mesh)
{
    return const_cast<fv::options*>(mesh.findObject<fv::options>(fv::options::typeName));
}

} // End namespace Foam


bool Foam::demDrivingForce::active(const fvMesh& mesh)
{
    fv::optionList* options = optionsOf(mesh);

    for (label k = 0; options && k < options->size(); k++)
    {
        if (isA<fv::meanVelocityForce>((*options)[k]))
        {
            return true;
        }
    }
    return false;
}


Foam::tmp<Foam::volVectorField> Foam::demDrivingForce::source
(
    const volVectorField& U,
    const dimensionSet& dimensions
)
{
    const fvMesh& mesh = U.mesh();
    fvVectorMatrix equation(U, dimensions*dimVolume);
    fv::optionList* options = optionsOf(mesh);

    for (label k = 0; options && k < options->size(); k++)
    {
        fv::option& option = (*options)[k];
        const label field = option.applyToField(U.name());

        if (isA<fv::meanVelocityForce>(option) && field >= 0 && option.isActive())
        {
            option.addSup(equation, field);
        }
    }

    tmp<volVectorField> tsource
    (
        new volVectorField
        (
            demFileAt(mesh.time().timeName(), "dem:drivingForce", mesh, IOobject::NO_READ),
            mesh,
            dimensionedVector(dimensions, Zero)
        )
    );
    tsource.ref().primitiveFieldRef() = -equation.source()/mesh.V();
    return tsource;
}

/*---------------------------------------------------------------------------*\
    demRotatingFrame.C -- zones of cells in a rotating frame.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRotatingFrame.H"
#include "IOdictionary.H"
#include "Time.H"


Foam::wordList Foam::demRotatingFrame::zones(const fvMesh& mesh)
{
    const IOdictionary all
    (
        IOobject
        (
            "MRFProperties",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    DynamicList<word> names;

    for (const entry& zone : all)
    {
        if (zone.isDict() && zone.dict().getOrDefault("active", true))
        {
            names.append(zone.keyword());
        }
    }
    return wordList(names);
}


void Foam::demRotatingFrame::check(const fvMesh& mesh, const bool demPimpleFoam)
{
    if (mesh.foundObject<IOdictionary>("SRFProperties"))
    {
        FatalErrorInFunction
            << "This solver's velocity is relative to a rotating frame"
            << " (constant/SRFProperties), but particles need the absolute one; take a mesh"
            << " that rotates, or MRF" << exit(FatalError);
    }

    const wordList names(zones(mesh));
    if (names.size())
    {
        FatalErrorInFunction
            << "Zone " << names[0] << " of constant/MRFProperties rotates, but "
            << (demPimpleFoam ? "demPimpleFoam" : "the particles' walls")
            << " would be at rest in it; let the mesh rotate, or set active no"
            << exit(FatalError);
    }
}

// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    demSlidingInterface.C -- patches between zones of cells that slide along each other.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSlidingInterface.H"
#include "cyclicAMIPolyPatch.H"


bool Foam::demSlidingInterface::is(const polyPatch& patch)
{
    return isA<cyclicAMIPolyPatch>(patch);
}


void Foam::demSlidingInterface::check(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (is(patch))
        {
            FatalErrorInFunction
                << "patch " << patch.name() << " is of type " << patch.type()
                << ", which particles do not pass; make the faces match and use cyclic,"
                << " or join the zones to one mesh" << exit(FatalError);
        }
    }
}

// ************************************************************************* //

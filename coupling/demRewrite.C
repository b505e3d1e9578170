/*---------------------------------------------------------------------------*\
    demRewrite.C -- puts the plan's choice of effects into demProperties.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRewrite.H"
#include "demCheck.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- While this lives errors are thrown, and nothing is told
class demTrial
{
    const int level_;
    const bool error_;
    const bool ioError_;

public:

    demTrial()
    :
        level_(messageStream::level),
        error_(FatalError.throwExceptions()),
        ioError_(FatalIOError.throwExceptions())
    {
        messageStream::level = 0;
    }

    ~demTrial()
    {
        messageStream::level = level_;
        FatalError.throwExceptions(error_);
        FatalIOError.throwExceptions(ioError_);
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demRewrite::judge
(
    const word& file,
    const struct ::dem_verdict** verdict,
    int* n
)
{
    autoPtr<demCloud> tried(new demCloud(mesh_, makesRoom_, file));

    if (verdict)
    {
        tried().plan(U_, gradP_, rho_, mu_, "");
        *n = tried().verdicts(*verdict);
        cloud_.reset(tried.ptr());
    }
}


const char* Foam::demRewrite::judge
(
    void* self,
    const char* file,
    const struct ::dem_verdict** verdict,
    int* n
)
{
    demRewrite& by = *static_cast<demRewrite*>(self);
    const demTrial quiet;

    try
    {
        by.judge(fileName(file).name(), verdict, n);
    }
    catch (const Foam::error& err)
    {
        by.wrong_ = err.message();
        by.wrong_.replaceAll("\n", " ");
        return by.wrong_.c_str();
    }
    return nullptr;
}


void Foam::demRewrite::tell(void*, const char* lines)
{
    Info<< lines << endl;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demRewrite::demRewrite
(
    const fvMesh& mesh,
    const bool makesRoom,
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu
)
:
    mesh_(mesh),
    makesRoom_(makesRoom),
    U_(U),
    gradP_(gradP),
    rho_(rho),
    mu_(mu)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demRewrite::write()
{
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "-write on " << Pstream::nProcs() << " ranks; one writes"
            << " constant/" << demDict::name() << ": leave mpirun and -parallel"
            << " out" << exit(FatalError);
    }

    const Time& time = mesh_.time();
    const fileName inCase(time.constant()/demDict::name());
    const fileName file(cwd() == time.path() ? inCase : time.path()/inCase);

    struct dem_rewriter how;
    how.scene = file.c_str();
    how.judge = judge;
    how.tell = tell;
    how.self = this;

    const int status = dem_rewrite(&how);
    {
        const demTrial quiet;
        cloud_.reset(nullptr);
    }
    demCheck(status);
}

// ************************************************************************* //

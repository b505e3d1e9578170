/*---------------------------------------------------------------------------*\
    demRewrite.C -- tests edited scenes for dem_scene_rewrite in the solver's mesh and fluid.

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

//- During its lifetime errors are exceptions and the log is silent
class demQuietErrors
{
    const int level_;
    const bool error_;
    const bool ioError_;

public:

    demQuietErrors()
    :
        level_(messageStream::level),
        error_(FatalError.throwExceptions()),
        ioError_(FatalIOError.throwExceptions())
    {
        messageStream::level = 0;
    }

    ~demQuietErrors()
    {
        messageStream::level = level_;
        FatalError.throwExceptions(error_);
        FatalIOError.throwExceptions(ioError_);
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demRewrite::testScene
(
    const word& file,
    const struct ::dem_verdict** verdict,
    int* n
)
{
    autoPtr<demCloud> trial(new demCloud(mesh_, volumeAveraged_, file));

    if (verdict)
    {
        trial().plan(U_, gradP_, rho_, mu_, "");
        *n = trial().lastPlan().verdicts(*verdict);
        cloud_.reset(trial.ptr());
    }
}


const char* Foam::demRewrite::testScene
(
    void* self,
    const char* file,
    const struct ::dem_verdict** verdict,
    int* n
)
{
    demRewrite& by = *static_cast<demRewrite*>(self);
    const demQuietErrors quiet;

    try
    {
        by.testScene(fileName(file).name(), verdict, n);
    }
    catch (const Foam::error& err)
    {
        by.refusal_ = err.message();
        by.refusal_.replaceAll("\n", " ");
        return by.refusal_.c_str();
    }
    return nullptr;
}


void Foam::demRewrite::report(void*, const char* lines)
{
    Info<< lines << endl;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demRewrite::demRewrite
(
    const fvMesh& mesh,
    const bool volumeAveraged,
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu
)
:
    mesh_(mesh),
    volumeAveraged_(volumeAveraged),
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

    struct dem_scene_rewriter how;
    how.scene = file.c_str();
    how.evaluate = testScene;
    how.report = report;
    how.self = this;

    const int status = dem_scene_rewrite(&how);
    {
        const demQuietErrors quiet;
        cloud_.reset(nullptr);
    }
    demCheck(status);
}

// ************************************************************************* //

# Everything that Glisson builds on, found once and here. Components are named one by one: Debian's OpenCV highgui
# and VTK's Qt support are Qt 5 and must never be linked.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE) # before ITK, which brings a target of the same name
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets Test LinguistTools)
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms CommonColor
  FiltersCore FiltersGeneral FiltersGeometry FiltersModeling FiltersSources FiltersExtraction
  IOCore IOGeometry IOLegacy IOXML IOImage
  ImagingCore
  InteractionStyle InteractionWidgets
  RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2)
find_package(ITK 5.2 REQUIRED COMPONENTS
  ITKCommon ITKIOImageBase ITKIOGDCM ITKGDCM ITKIONIFTI ITKIONRRD ITKIOMeta ITKIOVTK ITKImageFunction
  ITKImageGrid ITKImageIntensity ITKImageFeature ITKImageGradient ITKImageLabel ITKImageStatistics
  ITKSmoothing ITKThresholding ITKMathematicalMorphology ITKBinaryMathematicalMorphology
  ITKLabelMap ITKLevelSets ITKRegionGrowing ITKConnectedComponents ITKDistanceMap ITKFastMarching
  ITKCurvatureFlow ITKAnisotropicSmoothing ITKAntiAlias ITKBiasCorrection)
find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgproc imgcodecs calib3d aruco dnn features2d video videoio)
find_package(CGAL 5.5 REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(dlib REQUIRED)
find_package(OpenIGTLink 1.11 REQUIRED)
find_package(DCMTK 3.6.7 REQUIRED CONFIG)
find_package(SuiteSparse REQUIRED)

/* Numbers of the dialogs, controls and commands: for the resources and for the program. */
#ifndef RESOURCE_H
#define RESOURCE_H

#define IDD_TRAJECTORY 101
#define IDD_GENERAL 102
#define IDD_START 103
#define IDD_DISPLAY 104
#define IDD_COCKPIT 105
#define IDD_FAILURE 106
#define IDD_STUDY 107
#define IDD_MAIN 108
#define IDD_MANOEUVRE 109
#define IDR_MENU 120
#define IDR_TEXTS 121
#define IDR_KEYS 122
#define IDR_ICON 123

/* Main window. */
#define IDC_TABS 890
#define IDC_STATUS 891

/* Several controls have these numbers: headings, which are bold, and fields that a label binds to a key. */
#define IDC_HEADING 900
#define IDC_FIELD 901

/* Trajectory; the buttons of its list, and the lists of items. */
#define IDC_SOURCE 1001
#define IDC_BUILTIN 1002
#define IDC_TAKE 1003
#define IDC_BROWSE 1005
#define IDC_PORT 1006
#define IDC_RATE 1007
#define IDC_ITEMS 1020
#define IDC_ADD 1021
#define IDC_EDIT 1022
#define IDC_REMOVE 1023
#define IDC_UP 1024
#define IDC_DOWN 1025
#define IDC_TRACK 1030
#define IDC_PROFILE 1031

/* General parameters and sensors. */
#define IDC_HOURS 1102
#define IDC_SECTION 1120
#define IDC_PRESET 1121
#define IDC_EFFECTS 1123
#define IDC_EFFECT 1124
#define IDC_VALUE 1130 /* to 1138: a matrix row by row */
#define IDC_WORD 1140
#define IDC_UNIT 1141
#define IDC_SAME 1142
#define IDC_OFF 1143
#define IDC_APPLY 1144

/* Display. */
#define IDC_PLOT 1301
#define IDC_QUANTITY 1302
#define IDC_DATA2 1303
#define IDC_DATA1 1304
#define IDC_LOGARITHMIC 1305
#define IDC_AXIS 1306 /* to 1308 */
#define IDC_PACE 1311
#define IDC_PROGRESS 1312
#define IDC_VALUES 1313

/* A manoeuvre, a failure. */
#define IDC_KIND 1401
#define IDC_MESSAGE 1450
#define IDC_FAILURE_SIZE 1503
#define IDC_CLEAR 1509

/* The cockpit. */
#define IDC_COCKPIT 1700
#define IDC_ERRORS 1701
#define IDC_TAKE_OFF 1702
#define IDC_LEAVE 1703
#define IDC_SPEEDUP 1704
#define IDC_CHANNEL 1705
#define IDC_UNIT_STATE 1706
#define IDC_LATITUDE 1707
#define IDC_LONGITUDE 1708
#define IDC_HEADING_ENTERED 1709
#define IDC_MODE 1710 /* to 1713; from here on: the panel */
#define IDC_POWER 1714
#define IDC_TEST 1715
#define IDC_ENTER_TRUE 1716
#define IDC_ENTER_POSITION 1717
#define IDC_ENTER_HEADING 1718

/* The studies. */
#define IDC_FROM 1600
#define IDC_TO 1601
#define IDC_LIMIT 1602 /* to 1604: position, velocity, attitude */
#define IDC_LAST 1606  /* duration, or runs */
#define IDC_RESULT 1607
#define IDC_STATE 1608
#define IDC_COMPUTE 1609
#define IDC_ADOPT 1610
#define IDC_LAST_LABEL 1611

/* Commands: of the menu, and buttons of the display. */
#define ID_NEW 2001
#define ID_OPEN 2002
#define ID_SAVE 2003
#define ID_SAVE_AS 2004
#define ID_QUIT 2005
#define ID_ENGLISH 2006
#define ID_CHINESE 2007
#define ID_ABOUT 2008
#define ID_UNDO 2022
#define ID_HELP_KEYS 2009
#define ID_EXPORT 2010 /* from here on: buttons of the display; to ID_STOP: need a flight */
#define ID_PICTURE 2011
#define ID_COPY 2012
#define ID_SNAPSHOT 2013
#define ID_GO_BACK 2014
#define ID_PAUSE 2015
#define ID_STOP 2016
#define ID_PRINT 2023 /* needs a flight too */
#define ID_FLY 2017
#define ID_RESET 2018
#define ID_FAILURE 2019
#define ID_RECOMMEND 2020
#define ID_BUDGET 2021
#define ID_PAGE 2030    /* to 2034 */
#define ID_RECENT 2100  /* to 2107 */
#define ID_BUILTIN 2200 /* and those that follow */

#endif

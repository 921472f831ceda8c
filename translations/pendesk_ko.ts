<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko_KR">
<context>
    <name>Actions</name>
    <message>
        <source> or </source>
        <translation> 또는 </translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (소프트웨어)</translation>
    </message>
    <message>
        <source>Access level…</source>
        <translation>액세스 레벨…</translation>
    </message>
    <message>
        <source>Open this page in its own window</source>
        <translation>이 페이지를 별도의 창에서 열기</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>연결…</translation>
    </message>
    <message>
        <source>Connect to this controller</source>
        <translation>이 컨트롤러에 연결</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>연결 해제</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>데모 열기</translation>
    </message>
    <message>
        <source>Diagnose…</source>
        <translation>진단…</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>진단 복사</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Pendesk 정보</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>종료</translation>
    </message>
    <message>
        <source>Language and look…</source>
        <translation>언어와 모양…</translation>
    </message>
    <message>
        <source>Readiness…</source>
        <translation>준비 상태…</translation>
    </message>
    <message>
        <source>Help and shortcuts</source>
        <translation>도움말과 단축키</translation>
    </message>
</context>
<context>
    <name>Alarms</name>
    <message>
        <source>Major</source>
        <translation>중고장</translation>
    </message>
    <message>
        <source>Minor</source>
        <translation>경고장</translation>
    </message>
    <message>
        <source>User, system</source>
        <translation>유저 (시스템)</translation>
    </message>
    <message>
        <source>User</source>
        <translation>유저</translation>
    </message>
    <message>
        <source>Off-line</source>
        <translation>오프라인</translation>
    </message>
    <message>
        <source>◆ unacknowledged</source>
        <translation>◆ 미확인</translation>
    </message>
    <message>
        <source>■ acknowledged</source>
        <translation>■ 확인됨</translation>
    </message>
    <message>
        <source>▲ cleared, unacknowledged</source>
        <translation>▲ 해제됨, 미확인</translation>
    </message>
    <message>
        <source>□ cleared</source>
        <translation>□ 해제됨</translation>
    </message>
    <message>
        <source>No sub code.</source>
        <translation>서브 코드 없음.</translation>
    </message>
    <message>
        <source>%1: %2. As sent: %3, type %4.</source>
        <translation>%1: %2. 수신값: %3, 타입 %4.</translation>
    </message>
</context>
<context>
    <name>Conditions</name>
    <message>
        <source>%1: %2.</source>
        <comment>what is wrong: what helps</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>충족</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>미충족</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>아직 읽지 않음</translation>
    </message>
    <message>
        <source>cannot be read over HSES</source>
        <translation>HSES로는 읽을 수 없음</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what was tried: how it ended</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>동작 허가</translation>
    </message>
    <message>
        <source>Reset alarm</source>
        <translation>알람 리셋</translation>
    </message>
    <message>
        <source>Cancel error</source>
        <translation>에러 취소</translation>
    </message>
    <message>
        <source>Write a signal</source>
        <translation>신호 쓰기</translation>
    </message>
    <message>
        <source>Write a register</source>
        <translation>레지스터 쓰기</translation>
    </message>
    <message>
        <source>Write a variable</source>
        <translation>변수 쓰기</translation>
    </message>
    <message>
        <source>Select a job</source>
        <translation>잡 선택</translation>
    </message>
    <message>
        <source>Select a master job</source>
        <translation>마스터 잡 선택</translation>
    </message>
    <message>
        <source>Start the job</source>
        <translation>잡 기동</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (소프트웨어)</translation>
    </message>
    <message>
        <source>Release HOLD</source>
        <translation>HOLD 해제</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>서보 ON</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>서보 OFF</translation>
    </message>
    <message>
        <source>HLOCK on</source>
        <translation>HLOCK ON</translation>
    </message>
    <message>
        <source>HLOCK off</source>
        <translation>HLOCK OFF</translation>
    </message>
    <message>
        <source>Select the cycle mode</source>
        <translation>사이클 모드 선택</translation>
    </message>
    <message>
        <source>Show a message on the pendant</source>
        <translation>펜던트에 메시지 표시</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>조그</translation>
    </message>
    <message>
        <source>Send a file to the controller</source>
        <translation>컨트롤러로 파일 송신</translation>
    </message>
    <message>
        <source>Get a file from the controller</source>
        <translation>컨트롤러에서 파일 가져오기</translation>
    </message>
    <message>
        <source>Delete a file on the controller</source>
        <translation>컨트롤러의 파일 삭제</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>백업 복원</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>모니터</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>조작</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>엔지니어</translation>
    </message>
    <message>
        <source>disarmed by hand</source>
        <translation>수동으로 해제함</translation>
    </message>
    <message>
        <source>nobody used key or mouse for a minute</source>
        <translation>1분간 키와 마우스 조작 없음</translation>
    </message>
    <message>
        <source>another program came to the front</source>
        <translation>다른 프로그램이 앞으로 나옴</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>화면이 잠김</translation>
    </message>
    <message>
        <source>communication was lost</source>
        <translation>통신이 끊어짐</translation>
    </message>
    <message>
        <source>the mode changed at the controller</source>
        <translation>컨트롤러에서 모드가 변경됨</translation>
    </message>
    <message>
        <source>an alarm came up</source>
        <translation>알람이 발생함</translation>
    </message>
    <message>
        <source>the access level fell back</source>
        <translation>액세스 레벨이 되돌아감</translation>
    </message>
    <message>
        <source>another window came to the front</source>
        <translation>다른 창이 앞으로 나옴</translation>
    </message>
    <message>
        <source>another controller was armed</source>
        <translation>다른 컨트롤러가 동작 허가됨</translation>
    </message>
    <message>
        <source>The link to the controller is up</source>
        <translation>컨트롤러와 통신 중</translation>
    </message>
    <message>
        <source>The access level is Operate or Engineer</source>
        <translation>액세스 레벨이 “조작” 또는 “엔지니어”임</translation>
    </message>
    <message>
        <source>The access level is Engineer</source>
        <translation>액세스 레벨이 “엔지니어”임</translation>
    </message>
    <message>
        <source>The status is fresh</source>
        <translation>상태가 최신임</translation>
    </message>
    <message>
        <source>This controller is armed</source>
        <translation>이 컨트롤러가 동작 허가 중</translation>
    </message>
    <message>
        <source>REMOTE is on</source>
        <translation>REMOTE가 ON임</translation>
    </message>
    <message>
        <source>The mode is PLAY</source>
        <translation>모드가 PLAY임</translation>
    </message>
    <message>
        <source>The mode is not TEACH</source>
        <translation>모드가 TEACH가 아님</translation>
    </message>
    <message>
        <source>There is no alarm</source>
        <translation>알람 없음</translation>
    </message>
    <message>
        <source>There is no error</source>
        <translation>에러 없음</translation>
    </message>
    <message>
        <source>Not held by the pendant</source>
        <translation>펜던트에 의한 홀드 중이 아님</translation>
    </message>
    <message>
        <source>Not held by an external signal</source>
        <translation>외부 신호에 의한 홀드 중이 아님</translation>
    </message>
    <message>
        <source>Not held by a command</source>
        <translation>커맨드에 의한 홀드 중이 아님</translation>
    </message>
    <message>
        <source>Held by a command</source>
        <translation>커맨드에 의한 홀드 중</translation>
    </message>
    <message>
        <source>Servo power is on</source>
        <translation>서보 전원이 ON임</translation>
    </message>
    <message>
        <source>No job is running</source>
        <translation>실행 중인 잡이 없음</translation>
    </message>
    <message>
        <source>A job is selected</source>
        <translation>잡이 선택되어 있음</translation>
    </message>
    <message>
        <source>The numbering of variables is verified</source>
        <translation>변수 번호 방식이 대조됨</translation>
    </message>
    <message>
        <source>The model takes move orders</source>
        <translation>이 기종은 이동 명령을 받음</translation>
    </message>
    <message>
        <source>The safety circuit is closed</source>
        <translation>안전 회로가 닫혀 있음</translation>
    </message>
    <message>
        <source>Not held by a playback panel</source>
        <translation>플레이백 패널에 의한 홀드 중이 아님</translation>
    </message>
    <message>
        <source>Home position and position check are confirmed</source>
        <translation>원점 위치와 위치 확인이 완료됨</translation>
    </message>
    <message>
        <source>Starting is not locked at the panel</source>
        <translation>패널에서 기동이 잠겨 있지 않음</translation>
    </message>
    <message>
        <source>Mode and cycle are not locked at the panel</source>
        <translation>패널에서 모드와 사이클이 잠겨 있지 않음</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is permitted</source>
        <translation>REMOTE 및 PLAY에서의 잡 선택이 허가됨</translation>
    </message>
    <message>
        <source>Changing the master job is permitted</source>
        <translation>마스터 잡의 변경이 허가됨</translation>
    </message>
    <message>
        <source>The job exists on the controller</source>
        <translation>잡이 컨트롤러에 있음</translation>
    </message>
    <message>
        <source>Nothing is being edited at the pendant</source>
        <translation>펜던트에서 편집 중인 것이 없음</translation>
    </message>
    <message>
        <source>No other function uses the files</source>
        <translation>다른 기능이 파일을 사용하고 있지 않음</translation>
    </message>
    <message>
        <source>The data are not protected</source>
        <translation>데이터가 보호되어 있지 않음</translation>
    </message>
    <message>
        <source>Replacing existing files is permitted</source>
        <translation>기존 파일 바꾸기가 허가됨</translation>
    </message>
    <message>
        <source>There is no link to the controller</source>
        <translation>컨트롤러와 통신되지 않음</translation>
    </message>
    <message>
        <source>connect, or wait until it answers again</source>
        <translation>연결하거나, 다시 응답할 때까지 기다리십시오</translation>
    </message>
    <message>
        <source>The access level is Monitor</source>
        <translation>액세스 레벨이 “모니터”임</translation>
    </message>
    <message>
        <source>switch to Operate in the strip (Ctrl+L)</source>
        <translation>상태 표시줄에서 “조작”으로 전환하십시오 (Ctrl+L)</translation>
    </message>
    <message>
        <source>The access level is not Engineer</source>
        <translation>액세스 레벨이 “엔지니어”가 아님</translation>
    </message>
    <message>
        <source>switch to Engineer in the strip (Ctrl+L)</source>
        <translation>상태 표시줄에서 “엔지니어”로 전환하십시오 (Ctrl+L)</translation>
    </message>
    <message>
        <source>The status was not read just now</source>
        <translation>상태가 최신이 아님</translation>
    </message>
    <message>
        <source>wait a moment; if it stays so, look at the link</source>
        <translation>잠시 기다리십시오. 계속되면 통신을 확인하십시오</translation>
    </message>
    <message>
        <source>This controller is not armed</source>
        <translation>이 컨트롤러가 동작 허가되지 않음</translation>
    </message>
    <message>
        <source>arm it on this page</source>
        <translation>이 페이지에서 동작 허가하십시오</translation>
    </message>
    <message>
        <source>REMOTE is off</source>
        <translation>REMOTE가 OFF임</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1</source>
        <translation>펜던트의 모드 키를 REMOTE로 하고 CMD REMOTE SEL을 ON으로 하십시오: %1</translation>
    </message>
    <message>
        <source>The mode is not PLAY</source>
        <translation>모드가 PLAY가 아님</translation>
    </message>
    <message>
        <source>turn the pendant key to PLAY or REMOTE</source>
        <translation>펜던트의 모드 키를 PLAY 또는 REMOTE로 하십시오</translation>
    </message>
    <message>
        <source>The controller is in TEACH</source>
        <translation>컨트롤러가 TEACH 모드임</translation>
    </message>
    <message>
        <source>the person at the pendant has the robot: turn the key to REMOTE when that is over</source>
        <translation>펜던트를 가진 사람이 로봇을 조작 중입니다. 그 작업이 끝나면 모드 키를 REMOTE로 하십시오</translation>
    </message>
    <message>
        <source>There is an alarm</source>
        <translation>알람이 있음</translation>
    </message>
    <message>
        <source>remove its cause, then reset it on the Alarms page</source>
        <translation>원인을 제거한 후 “알람” 페이지에서 리셋하십시오</translation>
    </message>
    <message>
        <source>There is an error</source>
        <translation>에러가 있음</translation>
    </message>
    <message>
        <source>read it on the Alarms page, then cancel it</source>
        <translation>“알람” 페이지에서 내용을 읽은 후 취소하십시오</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>펜던트에 의한 홀드 중</translation>
    </message>
    <message>
        <source>release it there</source>
        <translation>홀드한 곳에서 해제하십시오</translation>
    </message>
    <message>
        <source>Held by an external signal</source>
        <translation>외부 신호에 의한 홀드 중</translation>
    </message>
    <message>
        <source>release it where that signal comes from</source>
        <translation>그 신호를 보내는 곳에서 해제하십시오</translation>
    </message>
    <message>
        <source>release HOLD on the Jobs page</source>
        <translation>“잡” 페이지에서 HOLD를 해제하십시오</translation>
    </message>
    <message>
        <source>No command holds the robot</source>
        <translation>커맨드에 의한 홀드 중이 아님</translation>
    </message>
    <message>
        <source>there is nothing to release from here</source>
        <translation>여기서 해제할 것이 없습니다</translation>
    </message>
    <message>
        <source>Servo power is off</source>
        <translation>서보 전원이 OFF임</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>서보를 ON으로 하십시오</translation>
    </message>
    <message>
        <source>A job is running</source>
        <translation>잡이 실행 중</translation>
    </message>
    <message>
        <source>wait until it has ended, or hold it</source>
        <translation>끝날 때까지 기다리거나 홀드하십시오</translation>
    </message>
    <message>
        <source>No job is selected</source>
        <translation>선택된 잡이 없음</translation>
    </message>
    <message>
        <source>select one on the Jobs page</source>
        <translation>“잡” 페이지에서 잡을 선택하십시오</translation>
    </message>
    <message>
        <source>The numbering of variables is not verified</source>
        <translation>변수 번호 방식이 대조되지 않음</translation>
    </message>
    <message>
        <source>compare two variables with the pendant (Variables page)</source>
        <translation>변수 두 개를 펜던트와 비교하십시오 (“변수” 페이지)</translation>
    </message>
    <message>
        <source>This model takes no move orders</source>
        <translation>이 기종은 이동 명령을 받지 않음</translation>
    </message>
    <message>
        <source>move it with the pendant</source>
        <translation>펜던트로 로봇을 움직이십시오</translation>
    </message>
    <message>
        <source>The safety circuit is open</source>
        <translation>안전 회로가 열려 있음</translation>
    </message>
    <message>
        <source>look at emergency stops, doors and the enabling switch</source>
        <translation>비상 정지, 안전문, 인에이블 스위치를 확인하십시오</translation>
    </message>
    <message>
        <source>Held by a playback panel</source>
        <translation>플레이백 패널에 의한 홀드 중</translation>
    </message>
    <message>
        <source>Home position or position check is missing</source>
        <translation>원점 위치 또는 위치 확인이 완료되지 않음</translation>
    </message>
    <message>
        <source>confirm the position at the pendant</source>
        <translation>펜던트에서 위치를 확인하십시오</translation>
    </message>
    <message>
        <source>Starting is locked at the panel</source>
        <translation>패널에서 기동이 잠겨 있음</translation>
    </message>
    <message>
        <source>release the start lock (I/O or panel prohibit) at the cell</source>
        <translation>셀에서 기동 잠금(I/O 또는 패널 조작 금지)을 해제하십시오</translation>
    </message>
    <message>
        <source>Mode and cycle are locked at the panel</source>
        <translation>패널에서 모드와 사이클이 잠겨 있음</translation>
    </message>
    <message>
        <source>release the panel lock (I/O or panel prohibit) at the cell</source>
        <translation>셀에서 패널 잠금(I/O 또는 패널 조작 금지)을 해제하십시오</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is prohibited</source>
        <translation>REMOTE 및 PLAY에서의 잡 선택이 금지됨</translation>
    </message>
    <message>
        <source>set “job select when remote and play” to permit: %1</source>
        <translation>“job select when remote and play”(REMOTE 및 PLAY에서의 잡 선택)를 허가로 설정하십시오: %1</translation>
    </message>
    <message>
        <source>Changing the master job is prohibited</source>
        <translation>마스터 잡의 변경이 금지됨</translation>
    </message>
    <message>
        <source>permit it at the pendant (master call, teach lock): %1</source>
        <translation>펜던트에서 허가하십시오 (마스터 호출, 티칭 잠금): %1</translation>
    </message>
    <message>
        <source>The job is not on the controller</source>
        <translation>잡이 컨트롤러에 없음</translation>
    </message>
    <message>
        <source>read the list of jobs again</source>
        <translation>잡 리스트를 다시 읽으십시오</translation>
    </message>
    <message>
        <source>Something is being edited at the pendant</source>
        <translation>펜던트에서 편집 중인 것이 있음</translation>
    </message>
    <message>
        <source>leave the editor there</source>
        <translation>펜던트에서 편집을 종료하십시오</translation>
    </message>
    <message>
        <source>Another function uses the files</source>
        <translation>다른 기능이 파일을 사용 중</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>잠시 후 다시 시도하십시오</translation>
    </message>
    <message>
        <source>The data are protected</source>
        <translation>데이터가 보호되어 있음</translation>
    </message>
    <message>
        <source>release the protection at the pendant</source>
        <translation>펜던트에서 보호를 해제하십시오</translation>
    </message>
    <message>
        <source>Replacing files is not permitted</source>
        <translation>파일 바꾸기가 허가되지 않음</translation>
    </message>
    <message>
        <source>set the parameters RS029 and RS214 to 1: %1</source>
        <translation>파라미터 RS029와 RS214를 1로 설정하십시오: %1</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION COND. 또는 FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or TEACHING COND.</source>
        <translation>SETUP, FUNCTION COND. 또는 TEACHING COND.</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE or TEACHING COND.</source>
        <translation>SETUP, FUNCTION ENABLE 또는 TEACHING COND.</translation>
    </message>
    <message>
        <source>PARAMETER, RS (management mode)</source>
        <translation>PARAMETER, RS (관리 모드)</translation>
    </message>
    <message>
        <source>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)</source>
        <translation>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (DX100에서는 #82015)</translation>
    </message>
    <message>
        <source>The controller shows an error</source>
        <translation>컨트롤러에 에러가 표시됨</translation>
    </message>
    <message>
        <source>The controller shows no error</source>
        <translation>컨트롤러에 에러가 표시되지 않음</translation>
    </message>
    <message>
        <source>there is nothing to cancel</source>
        <translation>취소할 것이 없습니다</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>연결이 닫힘</translation>
    </message>
    <message>
        <source>the language was changed</source>
        <translation>언어가 변경됨</translation>
    </message>
    <message>
        <source>the window was turned to another controller</source>
        <translation>창이 다른 컨트롤러로 전환됨</translation>
    </message>
    <message>
        <source>the computer went to sleep</source>
        <translation>컴퓨터가 절전 모드로 들어감</translation>
    </message>
    <message>
        <source>this program stood still, or the computer&apos;s clock jumped</source>
        <translation>이 프로그램이 멈췄거나 컴퓨터의 시계가 크게 바뀜</translation>
    </message>
</context>
<context>
    <name>FileSheet</name>
    <message>
        <source>There is no “%1”.</source>
        <translation>“%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>There is no folder “%1”.</source>
        <translation>폴더 “%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>“%1” exists already. Is it to be replaced?</source>
        <translation>“%1”이(가) 이미 있습니다. 바꾸시겠습니까?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>바꾸기</translation>
    </message>
</context>
<context>
    <name>LinkView</name>
    <message>
        <source>checking</source>
        <translation>확인 중</translation>
    </message>
    <message>
        <source>live</source>
        <translation>실시간</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>통신 끊김</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>연결 안 됨</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Diagnose…</source>
        <translation>진단…</translation>
    </message>
    <message>
        <source>HOLD not confirmed: use the pendant.</source>
        <translation>HOLD가 확인되지 않았습니다. 펜던트를 사용하십시오.</translation>
    </message>
    <message>
        <source>HOLD was refused: %1. Use the pendant.</source>
        <translation>HOLD가 거부되었습니다: %1. 펜던트를 사용하십시오.</translation>
    </message>
    <message>
        <source>No contact with %1 yet: %2. Checking goes on by itself.</source>
        <translation>아직 %1과(와) 통신되지 않습니다: %2. 확인은 자동으로 계속됩니다.</translation>
    </message>
    <message>
        <source>Checking %1: waiting for system information and status.</source>
        <translation>%1 확인 중: 시스템 정보와 상태를 기다리고 있습니다.</translation>
    </message>
    <message>
        <source>Communication lost at %1 — showing the last values read. Reading resumes by itself.</source>
        <translation>%1에 통신이 끊어졌습니다 — 마지막으로 읽은 값을 표시하고 있습니다. 읽기는 자동으로 재개됩니다.</translation>
    </message>
    <message numerus="yes">
        <source>Communication restored at %1. Lost %n time(s) since connecting.</source>
        <translation>
            <numerusform>%1에 통신이 복구되었습니다. 연결 후 %n회 끊어졌습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>HOLD was not sent: there is no connection to a controller. Use the pendant.</source>
        <translation>HOLD를 송신하지 않았습니다. 컨트롤러와 연결되어 있지 않습니다. 펜던트를 사용하십시오.</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>연결…</translation>
    </message>
</context>
<context>
    <name>Noise</name>
    <message>
        <source>Date of the last change of a job (///DATE)</source>
        <translation>잡의 마지막 변경 날짜 (///DATE)</translation>
    </message>
    <message>
        <source>Dates and times of day, such as 2026/01/31 08:30</source>
        <translation>날짜와 시각 (예: 2026/01/31 08:30)</translation>
    </message>
    <message>
        <source>Operating time counters, such as 18:19&apos;02</source>
        <translation>가동 시간 카운터 (예: 18:19&apos;02)</translation>
    </message>
    <message>
        <source>Blanks at the end of a line</source>
        <translation>행 끝의 공백</translation>
    </message>
    <message>
        <source>Line ends: CR LF or LF, and whether the last line has one</source>
        <translation>행 끝: CR LF 또는 LF, 마지막 행의 행 끝 유무</translation>
    </message>
</context>
<context>
    <name>OrderRecords</name>
    <message>
        <source>✓ done</source>
        <translation>✓ 완료</translation>
    </message>
    <message>
        <source>✗ refused</source>
        <translation>✗ 거부됨</translation>
    </message>
    <message>
        <source>▲ unknown</source>
        <translation>▲ 알 수 없음</translation>
    </message>
    <message>
        <source>□ not sent</source>
        <translation>□ 송신 안 함</translation>
    </message>
    <message>
        <source>□ cancelled</source>
        <translation>□ 취소됨</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>kept on this computer</source>
        <translation>이 컴퓨터에 보관됨</translation>
    </message>
    <message>
        <source>the last values read before %1</source>
        <translation>%1 이전에 마지막으로 읽은 값</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Overview</source>
        <translation>개요</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>레지스터</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>조그와 이동</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>트렌드</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>백업</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>조작 이력</translation>
    </message>
    <message>
        <source>The state of the robot at a glance: mode, cycle, servo, run, the three causes of a hold, alarm, error and speed limit, the executing job, the position of R1, and how well the link works.</source>
        <translation>로봇의 상태를 한눈에 표시합니다: 모드, 사이클, 서보, 운전, 세 가지 홀드 원인, 알람, 에러, 속도 제한, 실행 중인 잡, R1의 위치, 통신 상태.</translation>
    </message>
    <message>
        <source>“What can I do now?” lists what may be ordered. ✓ may be tried, ✗ may not, with the first reason beside it.</source>
        <translation>“지금 할 수 있는 것은?”에는 지령할 수 있는 조작이 표시됩니다. ✓는 시도할 수 있는 것, ✗는 시도할 수 없는 것이며 옆에 첫 번째 이유가 표시됩니다.</translation>
    </message>
    <message>
        <source>Bits that contradict each other, such as TEACH and PLAY, are shown side by side as they were received, under ▲.</source>
        <translation>TEACH와 PLAY처럼 서로 모순되는 비트는 수신한 그대로 ▲와 함께 나란히 표시합니다.</translation>
    </message>
    <message>
        <source>Copy beside the system information takes model and software to the clipboard. The right mouse button on a number adds it to the trend.</source>
        <translation>시스템 정보 옆의 “복사”는 기종과 소프트웨어를 클립보드에 복사합니다. 숫자를 마우스 오른쪽 버튼으로 누르면 트렌드에 추가할 수 있습니다.</translation>
    </message>
    <message>
        <source>Up to four active alarms, the newest first, and the past alarms that were read from the controller.</source>
        <translation>최대 4개의 발생 중인 알람(최신순)과 컨트롤러에서 읽은 과거 알람을 표시합니다.</translation>
    </message>
    <message>
        <source>Acknowledge is noted on this computer only: the robot does not hear of it.</source>
        <translation>“확인”은 이 컴퓨터에만 기록됩니다. 로봇에는 전달되지 않습니다.</translation>
    </message>
    <message>
        <source>Reset alarm and Cancel error are orders: they need REMOTE and the level Operate, and say before what they clear. After a reset that was accepted an alarm may stay: then its cause is still there.</source>
        <translation>“알람 리셋”과 “에러 취소”는 지령입니다. REMOTE와 “조작” 레벨이 필요하며, 해제할 대상을 미리 알려 줍니다. 리셋이 수락된 후에도 알람이 남을 수 있습니다. 이 경우 원인이 아직 남아 있습니다.</translation>
    </message>
    <message>
        <source>Read now fetches the history and keeps it in the journal, even after the controller has dropped it. Most frequent counts codes.</source>
        <translation>“지금 읽기”는 이력을 가져와 조작 이력에 보관합니다. 컨트롤러에서 이력이 없어진 후에도 남습니다. “발생 빈도순”은 코드별 횟수를 셉니다.</translation>
    </message>
    <message>
        <source>Notes keep what caused a code and what was done, on this computer.</source>
        <translation>“메모”에는 코드의 원인과 조치 내용을 이 컴퓨터에 보관합니다.</translation>
    </message>
    <message>
        <source>All signals of one area, a group of eight in a row. A filled square is 1, a hollow one 0; a frame marks what changed in the last two seconds.</source>
        <translation>한 신호 범위의 모든 신호를 표시합니다. 한 행은 신호 8개로 된 그룹 하나입니다. 채워진 사각형은 1, 빈 사각형은 0입니다. 테두리는 최근 2초 안에 바뀐 신호를 나타냅니다.</translation>
    </message>
    <message>
        <source>Only network inputs can be written over HSES, by an engineer. A write reads the group, changes one bit, shows old and new, and reads back: eight bits travel together.</source>
        <translation>HSES로는 네트워크 입력에만 쓸 수 있으며, “엔지니어” 레벨이 필요합니다. 쓰기는 그룹을 읽고, 비트 하나를 바꾸고, 이전 값과 새 값을 표시하고, 다시 읽어 확인합니다. 8개 비트가 함께 전송됩니다.</translation>
    </message>
    <message>
        <source>Names come from the controller&apos;s IONAME.DAT. The right mouse button names a signal here, or puts it on the tab Watch.</source>
        <translation>이름은 컨트롤러의 IONAME.DAT에서 가져옵니다. 마우스 오른쪽 버튼으로 여기서 신호의 이름을 지정하거나 신호를 “워치” 탭에 넣을 수 있습니다.</translation>
    </message>
    <message>
        <source>Watch counts edges and draws the last minute. It reads four times a second: shorter pulses are not seen.</source>
        <translation>“워치”는 에지를 세고 최근 1분을 그립니다. 초당 4회 읽으므로 더 짧은 펄스는 확인되지 않습니다.</translation>
    </message>
    <message>
        <source>Go to takes #27010 as well as IN#(1).</source>
        <translation>“바로 가기”에는 #27010과 IN#(1) 어느 쪽 형식으로도 입력할 수 있습니다.</translation>
    </message>
    <message>
        <source>The registers M000 to M999, as decimal, signed, hexadecimal or binary numbers. Only the rows in view are read.</source>
        <translation>레지스터 M000부터 M999까지를 10진수, 부호 있는 수, 16진수 또는 2진수로 표시합니다. 화면에 보이는 행만 읽습니다.</translation>
    </message>
    <message>
        <source>M000 to M559 can be written by an engineer; the others belong to the ladder.</source>
        <translation>M000부터 M559까지는 “엔지니어” 레벨에서 쓸 수 있습니다. 나머지는 래더가 사용합니다.</translation>
    </message>
    <message>
        <source>Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back.</source>
        <translation>편집기에서 Enter를 누르면 값이 쓰기 예정에 추가됩니다. 값은 황색이 되며 아무것도 송신되지 않습니다. “적용”은 쓰기 예정인 모든 값의 이전 값과 새 값을 표시하고, 각 값을 한 번만 쓴 후 다시 읽어 확인합니다.</translation>
    </message>
    <message>
        <source>A value that reads back differently is red and stays. Undo last stages the values from before the last Apply.</source>
        <translation>쓴 값과 다르게 읽힌 값은 적색이며 그대로 남습니다. “마지막 쓰기 되돌리기”는 마지막 “적용” 이전의 값을 쓰기 예정에 추가합니다.</translation>
    </message>
    <message>
        <source>The variables B I D R S P BP and EX with their names, their value before, and when they changed. Only the rows in view are read.</source>
        <translation>변수 B I D R S P BP EX의 이름, 이전 값, 변경 시각을 표시합니다. 화면에 보이는 행만 읽습니다.</translation>
    </message>
    <message>
        <source>Nothing is written before the numbering was compared with the pendant: Verify… does that, and only reads.</source>
        <translation>변수 번호 방식을 펜던트와 비교하기 전에는 아무것도 쓰지 않습니다. “대조…”가 그 비교를 수행하며, 읽기만 합니다.</translation>
    </message>
    <message>
        <source>Import and Export take CSV files; cells of a spreadsheet can be pasted. Both show first what would differ.</source>
        <translation>“가져오기”와 “내보내기”는 CSV 파일을 사용하며, 스프레드시트의 셀을 붙여 넣을 수도 있습니다. 가져올 때와 붙여 넣을 때는 달라질 내용을 먼저 표시합니다.</translation>
    </message>
    <message>
        <source>A watch page is a list of your own: the right mouse button puts rows of any tab on it.</source>
        <translation>워치 페이지는 직접 만드는 목록입니다. 마우스 오른쪽 버튼으로 임의의 탭의 행을 추가할 수 있습니다.</translation>
    </message>
    <message>
        <source>The tool point in the base frame, with form and tool; the axes in pulses with following error, torque and temperature where the model tells them; and the path of the tool point.</source>
        <translation>베이스 좌표에서의 제어점을 형태와 툴과 함께 표시합니다. 축은 펄스로 표시하고, 기종이 알려 주는 경우 위치 편차, 토크, 온도도 표시합니다. 제어점의 궤적도 표시합니다.</translation>
    </message>
    <message>
        <source>Degrees of axes stand here only where the profile gives pulses per degree: the controller does not tell them.</source>
        <translation>축의 각도는 프로파일에 1도당 펄스 수가 있을 때만 표시됩니다. 컨트롤러는 이를 알려 주지 않습니다.</translation>
    </message>
    <message>
        <source>Torque is shown as the controller sends it: its unit is stated nowhere.</source>
        <translation>토크는 컨트롤러가 보낸 그대로 표시합니다. 단위는 어디에도 명시되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>Min and max count from the last reset, while this page is read. Copy as text takes the table in view.</source>
        <translation>최소와 최대는 마지막 리셋 이후 이 페이지를 읽는 동안의 값으로 집계합니다. “텍스트로 복사”는 표시 중인 표를 복사합니다.</translation>
    </message>
    <message>
        <source>Control groups that the controller refuses have no tab; the line beside the tabs counts them.</source>
        <translation>컨트롤러가 거부하는 제어 그룹에는 탭이 없습니다. 탭 옆에 그 개수가 표시됩니다.</translation>
    </message>
    <message>
        <source>Moves the robot by orders, in automatic operation. The pendant&apos;s enabling switch does not protect anyone here, and nobody may be inside the fence. It is off in TEACH, always.</source>
        <translation>자동 운전 중에 지령으로 로봇을 움직입니다. 여기서는 펜던트의 인에이블 스위치가 아무도 보호하지 않으며, 안전 펜스 안에 아무도 있어서는 안 됩니다. TEACH에서는 항상 사용할 수 없습니다.</translation>
    </message>
    <message>
        <source>Arming needs the level Operate, REMOTE and PLAY; moving needs Engineer too. Losing the focus, a minute without a key or the mouse, an alarm or a lost link disarms.</source>
        <translation>동작 허가에는 “조작” 레벨, REMOTE, PLAY가 필요합니다. 이동에는 “엔지니어” 레벨도 필요합니다. 포커스를 잃거나, 1분간 키와 마우스 조작이 없거나, 알람이 발생하거나, 통신이 끊어지면 동작 허가가 해제됩니다.</translation>
    </message>
    <message>
        <source>Jog sends one bounded step after another while a button is held. Letting go sends no more steps and holds the one that runs; after a lost link the robot still ends its step.</source>
        <translation>조그는 버튼을 누르고 있는 동안 제한된 스텝을 하나씩 차례로 송신합니다. 손을 떼면 스텝을 더 송신하지 않고 실행 중인 스텝을 홀드합니다. 통신이 끊어지면 로봇은 실행 중인 스텝을 끝까지 실행합니다.</translation>
    </message>
    <message>
        <source>Move shows present place, target and change first. Rehearse… opens the sheet on which the move is confirmed.</source>
        <translation>이동은 현재 위치, 목표, 변화량을 먼저 표시합니다. “사전 확인…”은 이동을 확정하는 창을 엽니다.</translation>
    </message>
    <message>
        <source>What was sent without an answer is called unknown, never failed: look at the robot.</source>
        <translation>송신했으나 응답이 없는 것은 “실패”가 아니라 “알 수 없음”으로 표시합니다. 로봇을 확인하십시오.</translation>
    </message>
    <message>
        <source>Draws any number over time. Drag it here from a page, choose “Add to trend” in its menu, or use Add signal….</source>
        <translation>임의의 수를 시간에 따라 그립니다. 페이지에서 여기로 끌어 오거나, 그 메뉴에서 “트렌드에 추가”를 선택하거나, “신호 추가…”를 사용하십시오.</translation>
    </message>
    <message>
        <source>Pause freezes the view; recording goes on. Gaps in a curve are times in which nothing was read.</source>
        <translation>“일시 정지”는 표시를 멈춥니다. 기록은 계속됩니다. 곡선의 빈 구간은 아무것도 읽지 않은 시간입니다.</translation>
    </message>
    <message>
        <source>The time box chooses how long a time is in view; under the cursor stand the values of that moment.</source>
        <translation>표시 시간 상자에서 표시할 시간의 길이를 선택합니다. 커서 아래에 그 시점의 값이 표시됩니다.</translation>
    </message>
    <message>
        <source>An incident keeps 60 s before and 20 s after an alarm came up. It can be opened here later.</source>
        <translation>인시던트는 알람 발생 60초 전부터 20초 후까지를 보관합니다. 나중에 여기서 열 수 있습니다.</translation>
    </message>
    <message>
        <source>Export CSV… writes what is in view, with times in UTC.</source>
        <translation>“CSV 내보내기…”는 표시 범위를 쓰며, 시각은 UTC입니다.</translation>
    </message>
    <message>
        <source>The jobs on the controller and the text of the chosen one, with the line that is executed. A banner says when the text may be old.</source>
        <translation>컨트롤러의 잡과 선택한 잡의 내용을, 실행 중인 행과 함께 표시합니다. 내용이 이전 것일 수 있을 때는 배너로 알립니다.</translation>
    </message>
    <message>
        <source>Start needs REMOTE, PLAY, servo on, the level Operate and an armed controller. Its sheet names controller, job and line, and the button works after one second. Nothing is ever started twice.</source>
        <translation>기동에는 REMOTE, PLAY, 서보 ON, “조작” 레벨, 동작 허가된 컨트롤러가 필요합니다. 기동 창에는 컨트롤러, 잡, 행이 표시되며, 버튼은 1초 후에 작동합니다. 어떤 경우에도 두 번 기동하지 않습니다.</translation>
    </message>
    <message>
        <source>Buttons show what was read. “Pending” stands until the status agrees.</source>
        <translation>버튼은 읽은 상태를 표시합니다. “처리 중”은 상태가 일치할 때까지 표시됩니다.</translation>
    </message>
    <message>
        <source>HOLD from here can be released here. A hold by the pendant is released there.</source>
        <translation>여기서 건 HOLD는 여기서 해제할 수 있습니다. 펜던트에 의한 홀드는 펜던트에서 해제합니다.</translation>
    </message>
    <message>
        <source>“Why not?” beside a button lists all its conditions.</source>
        <translation>버튼 옆의 “불가한 이유는?”에는 그 버튼의 모든 조건이 표시됩니다.</translation>
    </message>
    <message>
        <source>Files of this computer on the left, of the controller on the right, by type.</source>
        <translation>왼쪽은 이 컴퓨터의 파일, 오른쪽은 컨트롤러의 파일이며, 타입별로 표시됩니다.</translation>
    </message>
    <message>
        <source>Fetch only reads. Send and Delete are for engineers and need REMOTE on.</source>
        <translation>“가져오기”는 읽기만 합니다. “송신”과 “삭제”에는 “엔지니어” 레벨이 필요하며 REMOTE가 ON이어야 합니다.</translation>
    </message>
    <message>
        <source>A file that exists already is asked about: compare it, replace it, or leave it, which is the default. A file cut off half way never replaces a good one.</source>
        <translation>이미 있는 파일은 처리 방법을 묻습니다. 비교하거나, 바꾸거나, 그대로 둘 수 있으며, 기본값은 그대로 두기입니다. 도중에 잘린 파일이 정상 파일을 바꾸는 일은 없습니다.</translation>
    </message>
    <message>
        <source>Before a job is sent its text is checked, and afterwards it is read back and compared.</source>
        <translation>잡은 송신하기 전에 내용을 검사하며, 송신 후에는 다시 읽어 비교합니다.</translation>
    </message>
    <message>
        <source>Transfers lists every file with its bytes and state. Retry failed sends none that was finished.</source>
        <translation>“전송”에는 모든 파일이 바이트 수, 상태와 함께 표시됩니다. “실패 항목 재시도”는 완료된 파일을 송신하지 않습니다.</translation>
    </message>
    <message>
        <source>Backups of this controller, the newest first, with the files that are missing in each. ▲ marks one that is not whole.</source>
        <translation>이 컨트롤러의 백업을 최신순으로 표시하고, 각 백업에 없는 파일을 함께 표시합니다. ▲는 완전하지 않은 백업을 나타냅니다.</translation>
    </message>
    <message>
        <source>Back up now reads every file into a new folder with a checksum of each. A file that fails does not stop the rest.</source>
        <translation>“지금 백업”은 모든 파일을 새 폴더로 읽고 각 파일의 체크섬을 기록합니다. 실패한 파일이 있어도 나머지는 계속합니다.</translation>
    </message>
    <message>
        <source>Verify reads every byte again. Compare finds what differs from another backup or from the controller now; dates and counters are left out, and the page says which.</source>
        <translation>“검증”은 모든 바이트를 다시 읽습니다. “비교”는 다른 백업 또는 컨트롤러의 현재 내용과 다른 점을 찾습니다. 날짜와 카운터는 제외하며, 제외한 항목은 페이지에 표시됩니다.</translation>
    </message>
    <message>
        <source>Restore… plans first, makes a fresh backup, sends what changed, and reads it back. It needs an engineer and REMOTE, and no job may run.</source>
        <translation>“복원…”은 먼저 계획을 세우고, 새 백업을 만들고, 변경된 것을 송신한 후 다시 읽어 확인합니다. “엔지니어” 레벨과 REMOTE가 필요하며, 실행 중인 잡이 없어야 합니다.</translation>
    </message>
    <message>
        <source>Old backups go by number and age as set below the list, never the last good one or a pinned one.</source>
        <translation>오래된 백업은 목록 아래에 설정한 개수와 기간에 따라 삭제됩니다. 마지막 양호한 백업과 고정된 백업은 삭제하지 않습니다.</translation>
    </message>
    <message>
        <source>Everything that was tried from here: writes, starts, moves, servo, files, and what was refused or withheld, with user, old and new value, and the controller&apos;s answer.</source>
        <translation>여기서 시도한 모든 것을 기록합니다: 쓰기, 기동, 이동, 서보, 파일, 그리고 거부되었거나 송신하지 않은 것. 조작자, 이전 값과 새 값, 컨트롤러의 응답을 함께 기록합니다.</translation>
    </message>
    <message>
        <source>“Unknown” means that no answer came: it may have happened.</source>
        <translation>“알 수 없음”은 응답이 오지 않았다는 뜻입니다. 실행되었을 수 있습니다.</translation>
    </message>
    <message>
        <source>Filter by controller, kind, time and outcome, or search in all texts. Older records come when scrolling down.</source>
        <translation>컨트롤러, 내용, 기간, 결과로 필터링하거나 모든 텍스트에서 검색하십시오. 이전 기록은 아래로 스크롤하면 표시됩니다.</translation>
    </message>
    <message>
        <source>The journal is kept on this computer for all controllers and can be read without a connection. Export writes what the filter shows.</source>
        <translation>조작 이력은 모든 컨트롤러의 것을 이 컴퓨터에 보관하며 연결 없이 읽을 수 있습니다. “내보내기”는 필터에 표시된 것을 씁니다.</translation>
    </message>
    <message>
        <source>Go to a signal</source>
        <translation>신호로 바로 가기</translation>
    </message>
    <message>
        <source>Write the signal (network inputs)</source>
        <translation>신호 쓰기 (네트워크 입력)</translation>
    </message>
    <message>
        <source>On the tab Watch: watch the signal no longer</source>
        <translation>“워치” 탭에서: 신호의 워치 중지</translation>
    </message>
    <message>
        <source>Go to a register</source>
        <translation>레지스터로 바로 가기</translation>
    </message>
    <message>
        <source>Open the editor; in it: stage the value</source>
        <translation>편집기 열기. 편집기에서: 값을 쓰기 예정에 추가</translation>
    </message>
    <message>
        <source>Discard the staged value</source>
        <translation>쓰기 예정인 값 폐기</translation>
    </message>
    <message>
        <source>Copy the chosen rows</source>
        <translation>선택한 행 복사</translation>
    </message>
    <message>
        <source>Paste cells: they are staged after a preview</source>
        <translation>셀 붙여 넣기: 미리 보기 후 쓰기 예정에 추가</translation>
    </message>
    <message>
        <source>Go to a variable</source>
        <translation>변수로 바로 가기</translation>
    </message>
    <message>
        <source>Held on a jog button: steps, if keyboard jog was switched on</source>
        <translation>조그 버튼에서 누르고 있기: 키보드 조그를 켠 경우 스텝 실행</translation>
    </message>
    <message>
        <source>In the sheet of the move, after typing its words: move</source>
        <translation>이동 창에서 지정된 문구를 입력한 후: 이동</translation>
    </message>
    <message>
        <source>In the plot: move the cursor</source>
        <translation>플롯에서: 커서 이동</translation>
    </message>
    <message>
        <source>In the plot: cursor to the oldest or newest time in view</source>
        <translation>플롯에서: 커서를 표시 범위의 가장 오래된 시각 또는 최신 시각으로 이동</translation>
    </message>
    <message>
        <source>In the plot: take the cursor away</source>
        <translation>플롯에서: 커서 제거</translation>
    </message>
    <message>
        <source>In the list of signals: remove it from the trend</source>
        <translation>신호 목록에서: 트렌드에서 제거</translation>
    </message>
    <message>
        <source>In the start sheet, after typing its words: start</source>
        <translation>기동 창에서 지정된 문구를 입력한 후: 기동</translation>
    </message>
    <message>
        <source>Copy the chosen rows of the list with the focus</source>
        <translation>포커스가 있는 목록에서 선택한 행 복사</translation>
    </message>
    <message>
        <source>“Job” is what the controller names: at rest the job that a start would begin, else the one that runs. “Run” says which.</source>
        <translation>“잡”은 컨트롤러가 알려 주는 잡입니다. 정지 중에는 기동하면 시작될 잡, 그 외에는 실행 중인 잡입니다. 어느 쪽인지는 “운전”에 표시됩니다.</translation>
    </message>
    <message>
        <source>All controllers side by side: those in alarm first, then those without a link and those that are held, then the others in a fixed order.</source>
        <translation>모든 컨트롤러를 나란히 표시합니다. 알람 중인 것이 먼저, 그다음이 통신되지 않는 것과 홀드 중인 것, 나머지는 정해진 순서입니다.</translation>
    </message>
    <message>
        <source>A click opens a controller’s pages. The others stay connected and are read once a second.</source>
        <translation>클릭하면 해당 컨트롤러의 페이지가 열립니다. 나머지는 연결된 채로 1초에 한 번 읽습니다.</translation>
    </message>
    <message>
        <source>HOLD ALL orders a software hold at every controller that is not off, asks nothing, and says of each whether it was confirmed. It is no emergency stop.</source>
        <translation>“전체 HOLD”는 OFF가 아닌 모든 컨트롤러에 소프트웨어 홀드를 지령합니다. 확인을 묻지 않으며, 컨트롤러마다 홀드가 확인되었는지 표시합니다. 비상 정지가 아닙니다.</translation>
    </message>
    <message>
        <source>Connect all and Back up all only read. Nothing else goes to several controllers at once.</source>
        <translation>“모두 연결”과 “모두 백업”은 읽기만 합니다. 그 외에는 여러 컨트롤러에 동시에 송신되는 것이 없습니다.</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>플릿</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>쉼표로 구분된 값 (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
</context>
<context>
    <name>Readiness</name>
    <message>
        <source>A signal group and a B variable were asked for: %1.</source>
        <translation>신호 그룹 하나와 B 변수 하나를 요청했습니다: %1.</translation>
    </message>
    <message>
        <source>A signal group and a B variable are asked for while this sheet is open. Writing needs no REMOTE; whether data are protected cannot be read.</source>
        <translation>이 창이 열려 있는 동안 신호 그룹 하나와 B 변수 하나를 요청합니다. 쓰기에는 REMOTE가 필요하지 않습니다. 데이터가 보호되어 있는지는 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>The software version, which tells the model, was not read yet.</source>
        <translation>기종을 알려 주는 소프트웨어 버전을 아직 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The profile says %1, but %2 is the software of a %3.</source>
        <translation>프로파일에는 %1(으)로 되어 있으나, %2은(는) %3의 소프트웨어입니다.</translation>
    </message>
    <message>
        <source>The software %1 does not tell the model. The ranges are those of the profile&apos;s %2.</source>
        <translation>소프트웨어 %1(으)로는 기종을 알 수 없습니다. 범위는 프로파일의 %2을(를) 따릅니다.</translation>
    </message>
    <message>
        <source>The software %1 is that of a %2. Its ranges come from a table, not from the controller.</source>
        <translation>소프트웨어 %1은(는) %2의 것입니다. 범위는 컨트롤러가 아니라 표에서 가져온 것입니다.</translation>
    </message>
    <message>
        <source>The last HOLD was refused: %1.</source>
        <translation>마지막 HOLD는 거부되었습니다: %1.</translation>
    </message>
    <message>
        <source>The last HOLD was confirmed by the status. It is a software hold, no emergency stop.</source>
        <translation>마지막 HOLD는 상태로 확인되었습니다. 이것은 소프트웨어 홀드이며 비상 정지가 아닙니다.</translation>
    </message>
    <message>
        <source>The last HOLD was sent, and the status did not confirm it.</source>
        <translation>마지막 HOLD를 송신했으나 상태로 확인되지 않았습니다.</translation>
    </message>
    <message>
        <source>It needs neither REMOTE nor an access level, and was not tried. It is a software hold, no emergency stop.</source>
        <translation>REMOTE도 액세스 레벨도 필요하지 않으며, 아직 시도하지 않았습니다. 이것은 소프트웨어 홀드이며 비상 정지가 아닙니다.</translation>
    </message>
    <message>
        <source>A list of jobs was asked for at port %1: %2.</source>
        <translation>포트 %1에 잡 목록을 요청했습니다: %2.</translation>
    </message>
    <message>
        <source>A list of jobs is asked for at port %1.</source>
        <translation>포트 %1에 잡 목록을 요청하고 있습니다.</translation>
    </message>
    <message>
        <source>Port %1 lists the jobs. Sending and deleting files need REMOTE.</source>
        <translation>포트 %1이(가) 잡 목록을 알려 줍니다. 파일의 송신과 삭제에는 REMOTE가 필요합니다.</translation>
    </message>
    <message>
        <source>This simulation has B000 at number %1 on the network.</source>
        <translation>이 시뮬레이션에서 B000은 네트워크의 번호 %1입니다.</translation>
    </message>
    <message>
        <source>The software version, with which it was compared, was not read yet.</source>
        <translation>비교했을 때의 소프트웨어 버전을 아직 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>It was compared with software %1, but %2 runs now: variables are not written before it is compared again.</source>
        <translation>소프트웨어 %1(으)로 비교했으나 지금은 %2이(가) 실행 중입니다. 다시 비교하기 전에는 변수에 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>Whether B000 is number 0 or 1 on the network is unverified; variables are not written.</source>
        <translation>네트워크에서 B000이 번호 0인지 번호 1인지 대조되지 않았습니다. 변수에는 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1: number 0 on the network is B000.</source>
        <translation>%1에 펜던트와 비교함: 네트워크의 번호 0이 B000입니다.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1, shifted: number 1 on the network is B000.</source>
        <translation>%1에 펜던트와 비교함, 어긋남 있음: 네트워크의 번호 1이 B000입니다.</translation>
    </message>
    <message>
        <source>The controller does not answer any more. Reading resumes by itself.</source>
        <translation>컨트롤러가 더 이상 응답하지 않습니다. 읽기는 자동으로 재개됩니다.</translation>
    </message>
    <message>
        <source>The controller tells its status and system information. Reading needs no REMOTE.</source>
        <translation>컨트롤러가 상태와 시스템 정보를 알려 줍니다. 읽기에는 REMOTE가 필요하지 않습니다.</translation>
    </message>
    <message>
        <source>Orders are taken in command remote alone: start, select, reset, cycle, servo on.</source>
        <translation>지령은 커맨드 리모트에서만 수락됩니다: 기동, 선택, 리셋, 사이클, 서보 ON.</translation>
    </message>
    <message>
        <source>It needs REMOTE, and that no job runs.</source>
        <translation>REMOTE가 필요하며, 실행 중인 잡이 없어야 합니다.</translation>
    </message>
    <message>
        <source>It needs PLAY, REMOTE, servo on and a job, and nothing that holds the robot.</source>
        <translation>PLAY, REMOTE, 서보 ON, 잡이 필요하며, 로봇을 홀드하는 것이 없어야 합니다.</translation>
    </message>
    <message>
        <source>It needs PLAY and REMOTE. Servo off can always be ordered from here; whether it is taken without REMOTE is up to the controller.</source>
        <translation>PLAY와 REMOTE가 필요합니다. 서보 OFF는 언제든지 여기서 지령할 수 있습니다. REMOTE 없이 수락될지는 컨트롤러에 따릅니다.</translation>
    </message>
    <message>
        <source>They need what a start needs, but for the job, and a model that knows them.</source>
        <translation>잡을 제외하고 기동에 필요한 조건이 모두 필요하며, 조그와 이동을 지원하는 기종이어야 합니다.</translation>
    </message>
    <message>
        <source>Sending a file that exists there needs REMOTE and two parameters.</source>
        <translation>컨트롤러에 이미 있는 파일을 송신하려면 REMOTE와 파라미터 2개가 필요합니다.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>읽기</translation>
    </message>
    <message>
        <source>I/O and variables</source>
        <translation>I/O와 변수</translation>
    </message>
    <message>
        <source>Ranges of the model</source>
        <translation>기종의 범위</translation>
    </message>
    <message>
        <source>Orders (REMOTE)</source>
        <translation>지령 (REMOTE)</translation>
    </message>
    <message>
        <source>Selecting a job</source>
        <translation>잡 선택</translation>
    </message>
    <message>
        <source>Starting a job</source>
        <translation>잡 기동</translation>
    </message>
    <message>
        <source>Switching servo on</source>
        <translation>서보 ON</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>조그와 이동</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (소프트웨어)</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Replacing files</source>
        <translation>파일 바꾸기</translation>
    </message>
    <message>
        <source>Numbering of variables</source>
        <translation>변수 번호 방식</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>허용됨</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>허용되지 않음</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>알 수 없음</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>실측</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>가정</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>읽을 수 없음</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>아직 읽지 않음</translation>
    </message>
    <message>
        <source>In the way: %1.</source>
        <translation>불가 원인: %1.</translation>
    </message>
    <message>
        <source>HSES does not tell whether this is so: %1.</source>
        <translation>다음이 충족되는지는 HSES로 알 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>What helps: %1.</source>
        <translation>해결 방법: %1.</translation>
    </message>
    <message>
        <source>Diagnose… in the rail finds out at which step it fails.</source>
        <translation>내비게이션 바의 “진단…”으로 어느 단계에서 불합격인지 알 수 있습니다.</translation>
    </message>
    <message>
        <source>Correct the model in the profile (Connect…).</source>
        <translation>프로파일의 기종을 수정하십시오 (“연결…”).</translation>
    </message>
    <message>
        <source>Use the pendant.</source>
        <translation>펜던트를 사용하십시오.</translation>
    </message>
    <message>
        <source>Pendesk %1, readiness of %2 (%3), %4, %5</source>
        <translation>Pendesk %1, %2의 준비 상태 (%3), %4, %5</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>subject, allowance, evidence</comment>
        <translation>%1: %2, %3</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>이 행에 있어야 할 숫자가 없습니다.</translation>
    </message>
</context>
<context>
    <name>Shown</name>
    <message>
        <source>Not read yet.</source>
        <translation>아직 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>거부됨: %1</translation>
    </message>
    <message>
        <source>Last seen %1</source>
        <translation>마지막 확인 %1</translation>
    </message>
    <message>
        <source>not taught</source>
        <translation>티칭 안 됨</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>HELD</source>
        <translation>홀드 중</translation>
    </message>
    <message>
        <source>no</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>PENDANT</source>
        <translation>펜던트</translation>
    </message>
    <message>
        <source>EXTERNAL</source>
        <translation>외부</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>커맨드</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>PLAY</translation>
    </message>
    <message>
        <source>NO MODE</source>
        <translation>모드 없음</translation>
    </message>
    <message>
        <source>REMOTE %1</source>
        <translation>REMOTE %1</translation>
    </message>
    <message>
        <source>STEP</source>
        <translation>스텝</translation>
    </message>
    <message>
        <source>1 CYCLE</source>
        <translation>1사이클</translation>
    </message>
    <message>
        <source>CONTINUOUS</source>
        <translation>연속</translation>
    </message>
    <message>
        <source>NO CYCLE</source>
        <translation>사이클 없음</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>운전 중</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>정지 중</translation>
    </message>
    <message>
        <source>ON</source>
        <translation>ON</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>off</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>ALARM</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>에러</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>error</source>
        <translation>에러</translation>
    </message>
    <message>
        <source>held</source>
        <translation>홀드 중</translation>
    </message>
    <message>
        <source>contradictory</source>
        <translation>모순</translation>
    </message>
    <message>
        <source>running</source>
        <translation>운전 중</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>대기 중</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>line %1 · step %2 · %3</source>
        <translation>행 %1 · 스텝 %2 · %3</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>펄스</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1초</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1분</translation>
    </message>
    <message>
        <source>HOLD asked for, %1 s…</source>
        <translation>HOLD 요청됨, %1초…</translation>
    </message>
    <message>
        <source>held by command</source>
        <translation>커맨드에 의한 홀드 중</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>펜던트에 의한 홀드 중</translation>
    </message>
    <message>
        <source>held externally</source>
        <translation>외부에 의한 홀드 중</translation>
    </message>
    <message>
        <source>HOLD refused</source>
        <translation>HOLD 거부됨</translation>
    </message>
    <message>
        <source>HOLD not confirmed</source>
        <translation>HOLD 확인되지 않음</translation>
    </message>
    <message>
        <source>released</source>
        <translation>해제됨</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>소프트웨어 홀드 · Pause 키</translation>
    </message>
</context>
<context>
    <name>cell::Sentences</name>
    <message>
        <source>%1 changed</source>
        <translation>%1 변경됨</translation>
    </message>
    <message>
        <source>new</source>
        <translation>새 항목</translation>
    </message>
    <message>
        <source>%1: gone.</source>
        <translation>%1: 없어졌습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) differ, from line %1 on.</source>
        <translation>
            <numerusform>행 %1부터 %n개 행이 다릅니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>The newer file is empty; what stood in it is not known to be deleted.</source>
        <translation>새 버전의 파일이 비어 있습니다. 있던 내용이 삭제되었는지는 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The older file is empty.</source>
        <translation>이전 버전의 파일이 비어 있습니다.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more difference(s).</source>
        <translation>
            <numerusform>그 외 차이 %n건.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes; the content differs.</source>
        <translation>%1바이트. 내용이 다릅니다.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>moved %1 mm (%2)</source>
        <translation>%1 mm 이동됨 (%2)</translation>
    </message>
    <message>
        <source>turned %1 deg (%2)</source>
        <translation>%1 deg 회전됨 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>Used by %n job(s).</source>
        <translation>
            <numerusform>%n개 잡에서 사용됩니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>could not be read in one of the files</source>
        <translation>한쪽 파일에서 읽을 수 없었음</translation>
    </message>
    <message>
        <source>name %1</source>
        <translation>이름 %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>제어점 %1</translation>
    </message>
    <message>
        <source>weight %1 kg</source>
        <translation>중량 %1 kg</translation>
    </message>
    <message>
        <source>centre of gravity %1 mm</source>
        <translation>무게중심 %1 mm</translation>
    </message>
    <message>
        <source>inertia %1 kgm²</source>
        <translation>관성 %1 kgm²</translation>
    </message>
    <message>
        <source>kind of entry %1</source>
        <translation>입력 방식 %1</translation>
    </message>
    <message>
        <source>%1 is new.</source>
        <translation>%1이(가) 추가되었습니다.</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1이(가) 없어졌습니다.</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>툴 %1</translation>
    </message>
    <message>
        <source>User frame %1</source>
        <translation>유저 좌표 %1</translation>
    </message>
    <message>
        <source>where it lies could not be read in one of the files</source>
        <translation>한쪽 파일에서 좌표의 위치를 읽을 수 없었음</translation>
    </message>
    <message>
        <source>taught with tool %1</source>
        <translation>툴 %1(으)로 티칭됨</translation>
    </message>
    <message>
        <source>taught at other points</source>
        <translation>다른 점에서 티칭됨</translation>
    </message>
    <message>
        <source>Area %1</source>
        <translation>영역 %1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>설정됨</translation>
    </message>
    <message>
        <source>no longer set</source>
        <translation>설정 해제됨</translation>
    </message>
    <message>
        <source>upper %1 %2 mm</source>
        <translation>상한 %1 %2 mm</translation>
    </message>
    <message>
        <source>lower %1 %2 mm</source>
        <translation>하한 %1 %2 mm</translation>
    </message>
    <message>
        <source>other coordinates or another group</source>
        <translation>좌표 또는 그룹이 다름</translation>
    </message>
    <message>
        <source>Collision detection, set %1, group %2</source>
        <translation>충돌 검출, 조건 %1, 그룹 %2</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>OFF로 변경됨</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>ON으로 변경됨</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>레벨 %1</translation>
    </message>
    <message>
        <source>robot %1 limit %2 %3 %4 deg</source>
        <translation>로봇 %1 리밋 %2 %3 %4 deg</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>변경됨</translation>
    </message>
    <message>
        <source>meaning not known</source>
        <translation>의미를 알 수 없음</translation>
    </message>
    <message>
        <source>Section %1 has %2 values.</source>
        <translation>섹션 %1의 값은 %2개입니다.</translation>
    </message>
    <message>
        <source>System part</source>
        <translation>시스템 부분</translation>
    </message>
    <message>
        <source>User part</source>
        <translation>유저 부분</translation>
    </message>
    <message>
        <source>decides %1</source>
        <translation>%1을(를) 결정</translation>
    </message>
    <message>
        <source>%1, instruction %2: %3</source>
        <translation>%1, 명령 %2: %3</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>%1이(가) %2(으)로 변경됨</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1이(가) 추가됨</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1이(가) 없어짐</translation>
    </message>
    <message>
        <source>Now also written: %1.</source>
        <translation>새로 쓰기 대상이 됨: %1.</translation>
    </message>
    <message>
        <source>No longer written: %1.</source>
        <translation>더 이상 쓰지 않음: %1.</translation>
    </message>
    <message>
        <source>The control group %1 is another one.</source>
        <translation>제어 그룹 %1이(가) 다른 그룹입니다.</translation>
    </message>
    <message>
        <source>Another number of control groups.</source>
        <translation>제어 그룹의 수가 다릅니다.</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1시간 %2분</translation>
    </message>
    <message>
        <source>The hours of control power went back by %1: another controller, or its memory was cleared.</source>
        <translation>제어 전원 시간이 %1만큼 줄었습니다. 다른 컨트롤러이거나 메모리가 지워졌습니다.</translation>
    </message>
    <message>
        <source>%1 powered in between.</source>
        <translation>그사이 %1 통전되었습니다.</translation>
    </message>
    <message>
        <source>Section %1 is new.</source>
        <translation>섹션 %1이(가) 추가되었습니다.</translation>
    </message>
    <message>
        <source>Section %1 is not in the newer file.</source>
        <translation>섹션 %1이(가) 새 버전의 파일에 없습니다.</translation>
    </message>
    <message>
        <source>Presets of timers and counters changed.</source>
        <translation>타이머와 카운터의 설정값이 변경되었습니다.</translation>
    </message>
    <message>
        <source>Home position of %1 axis %2 recalibrated (%3): taught points may be off.</source>
        <translation>%1 축 %2의 원점 위치가 다시 보정됨(%3): 티칭된 점이 어긋날 수 있습니다.</translation>
    </message>
    <message>
        <source>Position of %1 axis %2: %3 pulses.</source>
        <translation>%1 축 %2의 위치: %3 펄스.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ON</translation>
    </message>
    <message>
        <source>off</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source> Command remote select: HSES control is permitted.</source>
        <translation> 커맨드 리모트 선택: HSES 제어가 허가됩니다.</translation>
    </message>
    <message>
        <source> Command remote select: HSES control will be refused.</source>
        <translation> 커맨드 리모트 선택: HSES 제어가 거부됩니다.</translation>
    </message>
    <message>
        <source>Pseudo input %1 switched %2.</source>
        <translation>의사 입력 %1이(가) %2(으)로 전환됨.</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>소프트웨어</translation>
    </message>
    <message>
        <source>Parameter version</source>
        <translation>파라미터 버전</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>용도</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>기판</translation>
    </message>
    <message numerus="yes">
        <source>%n new entry(ies).</source>
        <translation>
            <numerusform>새 항목 %n건.</numerusform>
        </translation>
    </message>
    <message>
        <source>The log rolled over: edits in between are not known.</source>
        <translation>로그가 순환되어 덮어써졌습니다. 그사이의 편집은 알 수 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n new alarm(s): %1.</source>
        <translation>
            <numerusform>새 알람 %n건: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>coordinates %1</source>
        <translation>좌표 %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>툴 %1</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>유저 좌표 %1</translation>
    </message>
    <message>
        <source>form of the arm</source>
        <translation>암 형태</translation>
    </message>
    <message>
        <source>now set (%1)</source>
        <translation>설정됨 (%1)</translation>
    </message>
    <message>
        <source>Number of variables %1</source>
        <translation>변수 %1의 수</translation>
    </message>
    <message>
        <source>%1 lost its name “%2”.</source>
        <translation>%1의 이름 “%2”이(가) 없어졌습니다.</translation>
    </message>
    <message>
        <source>%1 is now named “%2”.</source>
        <translation>%1의 새 이름은 “%2”입니다.</translation>
    </message>
    <message>
        <source>%1 “%2” is now named “%3”.</source>
        <translation>%1 “%2”의 새 이름은 “%3”입니다.</translation>
    </message>
    <message>
        <source>written</source>
        <translation>쓰기</translation>
    </message>
    <message>
        <source>read</source>
        <translation>읽기</translation>
    </message>
    <message>
        <source>waited for</source>
        <translation>대기</translation>
    </message>
    <message>
        <source>called</source>
        <translation>호출</translation>
    </message>
    <message>
        <source>jumped to</source>
        <translation>점프 대상</translation>
    </message>
    <message>
        <source>started</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>named</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>may be %1</source>
        <translation>%1 가능성</translation>
    </message>
    <message>
        <source>%1 line %2</source>
        <translation>%1 %2행</translation>
    </message>
    <message>
        <source>%1 is called, and no file has it: %2.</source>
        <translation>%1이(가) 호출되지만 어느 파일에도 없습니다: %2.</translation>
    </message>
    <message>
        <source>%1 is written in several places: %2.</source>
        <translation>%1은(는) 여러 곳에서 쓰입니다: %2.</translation>
    </message>
    <message>
        <source>%1 is read and never written in the files: %2.</source>
        <translation>%1은(는) 읽히지만 파일에서 쓰이지 않습니다: %2.</translation>
    </message>
    <message>
        <source>%1 has several names: %2.</source>
        <translation>%1에 이름이 여러 개 있습니다: %2.</translation>
    </message>
    <message>
        <source>%1 is used and its data were not entered: %2.</source>
        <translation>%1이(가) 사용되지만 데이터가 입력되지 않았습니다: %2.</translation>
    </message>
    <message>
        <source>%1 is named by no other job and no macro.</source>
        <translation>다른 작업이나 매크로에서 %1을(를) 참조하지 않습니다.</translation>
    </message>
</context>
<context>
    <name>cellfiles::Sentences</name>
    <message>
        <source>values</source>
        <translation>값</translation>
    </message>
    <message>
        <source>block</source>
        <translation>블록</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>항목</translation>
    </message>
    <message>
        <source>value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>job</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>line</source>
        <translation>행</translation>
    </message>
    <message>
        <source>text</source>
        <translation>텍스트</translation>
    </message>
    <message>
        <source>collision detection</source>
        <translation>충돌 검출</translation>
    </message>
    <message>
        <source>set</source>
        <translation>조건</translation>
    </message>
    <message>
        <source>group</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ON</translation>
    </message>
    <message>
        <source>level</source>
        <translation>레벨</translation>
    </message>
    <message>
        <source>reasons of stops</source>
        <translation>정지 원인</translation>
    </message>
    <message>
        <source>number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>reasons</source>
        <translation>원인</translation>
    </message>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>이 행에 있어야 할 숫자가 없습니다.</translation>
    </message>
    <message>
        <source>The block has no number.</source>
        <translation>블록에 번호가 없습니다.</translation>
    </message>
    <message>
        <source>Tool %1 is not complete.</source>
        <translation>툴 %1이(가) 불완전합니다.</translation>
    </message>
    <message>
        <source>User frame %1 is not complete: where it lies is unknown.</source>
        <translation>유저 좌표 %1이(가) 불완전합니다. 좌표의 위치를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>툴</translation>
    </message>
    <message>
        <source>User frames</source>
        <translation>유저 좌표</translation>
    </message>
    <message>
        <source>Interference areas</source>
        <translation>간섭 영역</translation>
    </message>
    <message>
        <source>Collision detection</source>
        <translation>충돌 검출</translation>
    </message>
    <message>
        <source>Weaving conditions</source>
        <translation>위빙 조건</translation>
    </message>
    <message>
        <source>Arc start conditions</source>
        <translation>아크 스타트 조건</translation>
    </message>
    <message>
        <source>Arc end conditions</source>
        <translation>아크 엔드 조건</translation>
    </message>
    <message>
        <source>Arc auxiliary conditions</source>
        <translation>아크 보조 조건</translation>
    </message>
    <message>
        <source>Welders</source>
        <translation>용접기</translation>
    </message>
    <message>
        <source>Cutting shapes</source>
        <translation>절단 형상</translation>
    </message>
    <message>
        <source>Maintenance conditions</source>
        <translation>보전 조건</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>Names of variables</source>
        <translation>변수 이름</translation>
    </message>
    <message>
        <source>Names of signals</source>
        <translation>신호 이름</translation>
    </message>
    <message>
        <source>Names of external signals</source>
        <translation>외부 신호 이름</translation>
    </message>
    <message>
        <source>Names of registers</source>
        <translation>레지스터 이름</translation>
    </message>
    <message>
        <source>Names of timers</source>
        <translation>타이머 이름</translation>
    </message>
    <message>
        <source>Timers</source>
        <translation>타이머</translation>
    </message>
    <message>
        <source>Timer settings</source>
        <translation>타이머 설정</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>워치 리스트</translation>
    </message>
    <message>
        <source>Groups of signals</source>
        <translation>신호 그룹</translation>
    </message>
    <message>
        <source>User words</source>
        <translation>유저 용어</translation>
    </message>
    <message>
        <source>User menus</source>
        <translation>유저 메뉴</translation>
    </message>
    <message>
        <source>Names of flags</source>
        <translation>플래그 이름</translation>
    </message>
    <message>
        <source>Key functions</source>
        <translation>키 기능</translation>
    </message>
    <message>
        <source>Interface panels</source>
        <translation>인터페이스 패널</translation>
    </message>
    <message>
        <source>Macro commands</source>
        <translation>매크로 명령</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>래더</translation>
    </message>
    <message>
        <source>Pseudo inputs</source>
        <translation>의사 입력</translation>
    </message>
    <message>
        <source>I/O boards</source>
        <translation>I/O 기판</translation>
    </message>
    <message>
        <source>I/O axes</source>
        <translation>I/O 축</translation>
    </message>
    <message>
        <source>EtherNet/IP</source>
        <translation>EtherNet/IP</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>네트워크</translation>
    </message>
    <message>
        <source>Address translation</source>
        <translation>주소 변환</translation>
    </message>
    <message>
        <source>Remote users</source>
        <translation>리모트 유저</translation>
    </message>
    <message>
        <source>Home positions of the encoders</source>
        <translation>엔코더의 원점 위치</translation>
    </message>
    <message>
        <source>Second home position</source>
        <translation>제2원점 위치</translation>
    </message>
    <message>
        <source>Operation origin</source>
        <translation>작업 원점</translation>
    </message>
    <message>
        <source>Robot calibration</source>
        <translation>로봇 간 캘리브레이션</translation>
    </message>
    <message>
        <source>Tool interference</source>
        <translation>툴 간섭</translation>
    </message>
    <message>
        <source>Arrangement of robots</source>
        <translation>로봇 배치</translation>
    </message>
    <message>
        <source>Approach buzzer</source>
        <translation>접근 부저</translation>
    </message>
    <message>
        <source>Servo assistance</source>
        <translation>서보 어시스트</translation>
    </message>
    <message>
        <source>Safety logic</source>
        <translation>안전 로직</translation>
    </message>
    <message>
        <source>Range limits</source>
        <translation>범위 제한</translation>
    </message>
    <message>
        <source>Axis speed monitor</source>
        <translation>축 속도 감시</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>속도 제한</translation>
    </message>
    <message>
        <source>Tool angle monitor</source>
        <translation>툴 각도 감시</translation>
    </message>
    <message>
        <source>Check sums of safety data</source>
        <translation>안전 데이터의 체크섬</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>파라미터</translation>
    </message>
    <message>
        <source>System</source>
        <translation>시스템</translation>
    </message>
    <message>
        <source>System, options and change dates</source>
        <translation>시스템, 옵션, 변경 날짜</translation>
    </message>
    <message>
        <source>Operation log</source>
        <translation>조작 로그</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>알람 이력</translation>
    </message>
    <message>
        <source>Message history</source>
        <translation>메시지 이력</translation>
    </message>
    <message>
        <source>Fast events</source>
        <translation>고속 이벤트</translation>
    </message>
    <message>
        <source>Reasons of stops</source>
        <translation>정지 원인</translation>
    </message>
    <message>
        <source>Maintenance counters</source>
        <translation>보전 카운터</translation>
    </message>
    <message>
        <source>Torque counters</source>
        <translation>토크 카운터</translation>
    </message>
    <message>
        <source>Encoder heat</source>
        <translation>엔코더 발열</translation>
    </message>
    <message>
        <source>Step diagnosis</source>
        <translation>스텝 진단</translation>
    </message>
    <message>
        <source>Job monitor</source>
        <translation>잡 모니터</translation>
    </message>
    <message>
        <source>Robot monitor</source>
        <translation>로봇 모니터</translation>
    </message>
    <message>
        <source>Servo monitor</source>
        <translation>서보 모니터</translation>
    </message>
    <message>
        <source>Regeneration unit</source>
        <translation>회생 유닛</translation>
    </message>
    <message>
        <source>Memory image</source>
        <translation>메모리 이미지</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>로그</translation>
    </message>
    <message>
        <source>Unknown file</source>
        <translation>알 수 없는 파일</translation>
    </message>
    <message>
        <source>The file ends before the values of %1.</source>
        <translation>파일이 %1의 값 앞에서 끝납니다.</translation>
    </message>
    <message>
        <source>The control groups of this line could not be read.</source>
        <translation>이 행의 제어 그룹을 읽을 수 없었습니다.</translation>
    </message>
    <message>
        <source>This section is not understood.</source>
        <translation>이 섹션을 해석할 수 없습니다.</translation>
    </message>
    <message>
        <source>“%1” is not understood.</source>
        <translation>“%1”을(를) 해석할 수 없습니다.</translation>
    </message>
    <message>
        <source>The record in front of this date is not understood.</source>
        <translation>이 날짜 앞의 기록을 해석할 수 없습니다.</translation>
    </message>
    <message>
        <source>The record that begins here is not complete.</source>
        <translation>여기서 시작하는 기록이 불완전합니다.</translation>
    </message>
    <message>
        <source>The section %1 announces %2 records and holds %3.</source>
        <translation>섹션 %1에는 기록이 %2건으로 되어 있으나 실제는 %3건입니다.</translation>
    </message>
    <message>
        <source>The entry is numbered %1 and is number %2 by its place.</source>
        <translation>항목의 번호는 %1이지만 위치상으로는 %2번입니다.</translation>
    </message>
    <message>
        <source>The entry is not complete.</source>
        <translation>항목이 불완전합니다.</translation>
    </message>
    <message>
        <source>The number of the macro cannot be read.</source>
        <translation>매크로의 번호를 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>The line holds NUL bytes.</source>
        <translation>행에 NUL 바이트가 있습니다.</translation>
    </message>
    <message>
        <source>Lines end in LF alone. A pendant may take such a file for empty: convert it to CR LF before it is loaded.</source>
        <translation>행 끝이 LF뿐입니다. 펜던트가 이런 파일을 빈 파일로 볼 수 있습니다. 로드하기 전에 CR LF로 변환하십시오.</translation>
    </message>
    <message>
        <source>The file ends within a line: it may be cut.</source>
        <translation>파일이 행 도중에서 끝납니다. 잘렸을 수 있습니다.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>파일이 비어 있습니다.</translation>
    </message>
    <message>
        <source>The file is too long to be read.</source>
        <translation>파일이 너무 길어 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>%1 has no section “%2”; the rows below it are not understood.</source>
        <translation>%1에는 섹션 “%2”이(가) 없습니다. 그 아래 행은 해석할 수 없습니다.</translation>
    </message>
    <message>
        <source>The row has %1 instead of 10 values; the missing ones of %2 are unknown.</source>
        <translation>행의 값이 10개가 아니라 %1개입니다. %2의 빠진 값은 알 수 없습니다.</translation>
    </message>
    <message>
        <source>%1 is no number of 32 bits.</source>
        <translation>%1은(는) 32비트 숫자가 아닙니다.</translation>
    </message>
    <message>
        <source>data transmission; 2 is over the network</source>
        <translation>데이터 전송. 2는 네트워크 경유</translation>
    </message>
    <message>
        <source>numbering of variables for network clients; 1: by their number, 0: by their number plus one</source>
        <translation>네트워크 클라이언트의 변수 번호 방식. 1: 변수 번호 그대로, 0: 변수 번호 더하기 1</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files</source>
        <translation>1이면 네트워크 클라이언트의 파일 덮어쓰기 허가</translation>
    </message>
    <message>
        <source>serial transmission: data bits, parity, stop, speed, timers</source>
        <translation>시리얼 전송: 데이터 비트, 패리티, 정지 비트, 속도, 타이머</translation>
    </message>
    <message>
        <source>3 permits overwriting when loading from USB</source>
        <translation>3이면 USB에서 로드할 때 덮어쓰기 허가</translation>
    </message>
    <message>
        <source>address and mask of the controller</source>
        <translation>컨트롤러의 주소와 마스크</translation>
    </message>
    <message>
        <source>1 permits FTP</source>
        <translation>1이면 FTP 허가</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files; the meaning of 2 is not known</source>
        <translation>1이면 네트워크 클라이언트의 파일 덮어쓰기 허가. 2의 의미는 알 수 없음</translation>
    </message>
    <message>
        <source>addresses and masks</source>
        <translation>주소와 마스크</translation>
    </message>
    <message>
        <source>0 permits selecting jobs in remote and play</source>
        <translation>0이면 REMOTE 및 PLAY에서의 잡 선택 허가</translation>
    </message>
    <message>
        <source>pendant operation in remote; 63 permits starts and edits</source>
        <translation>REMOTE에서의 펜던트 조작. 63이면 기동과 편집 허가</translation>
    </message>
    <message>
        <source>alias function; 0 permits loading own names</source>
        <translation>별명 기능. 0이면 사용자 이름 로드 허가</translation>
    </message>
    <message>
        <source>drivers that start motion need 0</source>
        <translation>동작을 시작하는 드라이버에는 0이 필요</translation>
    </message>
    <message>
        <source>MotoPlus and telnet settings</source>
        <translation>MotoPlus와 telnet 설정</translation>
    </message>
    <message>
        <source>number of variables of each kind</source>
        <translation>종류별 변수의 수</translation>
    </message>
    <message>
        <source>control groups and their axes</source>
        <translation>제어 그룹과 그 축</translation>
    </message>
    <message>
        <source>pseudo input signals</source>
        <translation>의사 입력 신호</translation>
    </message>
    <message>
        <source>The name “%1” holds bytes that the text encoding does not know.</source>
        <translation>이름 “%1”에 문자 코드에 없는 바이트가 있습니다.</translation>
    </message>
    <message>
        <source>The row has more than four names.</source>
        <translation>행에 이름이 5개 이상 있습니다.</translation>
    </message>
    <message>
        <source>There are more names than signals.</source>
        <translation>이름이 신호보다 많습니다.</translation>
    </message>
    <message>
        <source>The row is not a number, two flags and a name.</source>
        <translation>행이 번호, 플래그 2개, 이름의 형식이 아닙니다.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is beyond the %n variable(s) that the file announces.</source>
        <translation>
            <numerusform>%1은(는) 파일에 지정된 변수 %n개를 넘습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was named “%2” before; which name the pendant shows is not known.</source>
        <translation>%1의 이름은 앞에서 “%2”(으)로 되어 있습니다. 펜던트에 어느 이름이 표시되는지 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The line stands in a section that names no signals.</source>
        <translation>신호 이름이 아닌 섹션의 행입니다.</translation>
    </message>
    <message>
        <source>The line does not announce a number for each of the eight kinds.</source>
        <translation>행에 8가지 종류 각각의 수가 지정되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>The hours could not be read.</source>
        <translation>시간을 읽을 수 없었습니다.</translation>
    </message>
    <message>
        <source>The file does not say the version of the system software.</source>
        <translation>파일에 시스템 소프트웨어의 버전이 없습니다.</translation>
    </message>
    <message>
        <source>system</source>
        <translation>시스템</translation>
    </message>
    <message>
        <source>model</source>
        <translation>기종</translation>
    </message>
    <message>
        <source>software</source>
        <translation>소프트웨어</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>파라미터</translation>
    </message>
    <message>
        <source>application</source>
        <translation>용도</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n axis/axes</source>
        <translation>
            <numerusform>%1, %n축</numerusform>
        </translation>
    </message>
    <message>
        <source>boards</source>
        <translation>기판</translation>
    </message>
    <message>
        <source>board</source>
        <translation>기판</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>counter</source>
        <translation>카운터</translation>
    </message>
    <message>
        <source>options</source>
        <translation>옵션</translation>
    </message>
    <message>
        <source>name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>state</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>설정</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>파라미터</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>의미</translation>
    </message>
    <message>
        <source>ladder</source>
        <translation>래더</translation>
    </message>
    <message>
        <source>part</source>
        <translation>부분</translation>
    </message>
    <message>
        <source>instruction</source>
        <translation>명령</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>텍스트</translation>
    </message>
    <message>
        <source>table</source>
        <translation>표</translation>
    </message>
    <message>
        <source>operation log</source>
        <translation>조작 로그</translation>
    </message>
    <message>
        <source>event</source>
        <translation>이벤트</translation>
    </message>
    <message>
        <source>alarm history</source>
        <translation>알람 이력</translation>
    </message>
    <message>
        <source>class</source>
        <translation>분류</translation>
    </message>
    <message>
        <source>code</source>
        <translation>코드</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>상세</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>모드</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>입력 안 됨</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>수동</translation>
    </message>
    <message>
        <source>measured load</source>
        <translation>측정 부하</translation>
    </message>
    <message>
        <source>base coordinates</source>
        <translation>베이스 좌표</translation>
    </message>
    <message>
        <source>robot coordinates</source>
        <translation>로봇 좌표</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>유저 좌표 %1</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>미사용</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>툴</translation>
    </message>
    <message>
        <source>weight kg</source>
        <translation>중량 kg</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>입력 방식</translation>
    </message>
    <message>
        <source>user frames</source>
        <translation>유저 좌표</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>툴</translation>
    </message>
    <message>
        <source>interference areas</source>
        <translation>간섭 영역</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>lower X mm</source>
        <translation>하한 X mm</translation>
    </message>
    <message>
        <source>upper X mm</source>
        <translation>상한 X mm</translation>
    </message>
    <message>
        <source>lower Y mm</source>
        <translation>하한 Y mm</translation>
    </message>
    <message>
        <source>upper Y mm</source>
        <translation>상한 Y mm</translation>
    </message>
    <message>
        <source>lower Z mm</source>
        <translation>하한 Z mm</translation>
    </message>
    <message>
        <source>upper Z mm</source>
        <translation>상한 Z mm</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>설정 안 됨</translation>
    </message>
    <message>
        <source>variables</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>유저 좌표</translation>
    </message>
    <message>
        <source>form</source>
        <translation>형태</translation>
    </message>
    <message>
        <source>names</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>신호</translation>
    </message>
    <message>
        <source>register</source>
        <translation>레지스터</translation>
    </message>
    <message>
        <source>timer</source>
        <translation>타이머</translation>
    </message>
    <message>
        <source>home positions, pulses</source>
        <translation>원점 위치, 펄스</translation>
    </message>
    <message>
        <source>pseudo inputs</source>
        <translation>의사 입력</translation>
    </message>
    <message>
        <source>byte</source>
        <translation>바이트</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>비트</translation>
    </message>
    <message>
        <source>The value of %1 could not be read.</source>
        <translation>%1의 값을 읽을 수 없었습니다.</translation>
    </message>
    <message>
        <source>The file announces %1 variables %2 and has %3; the others are not known.</source>
        <translation>파일에는 변수 %2이(가) %1개로 되어 있으나 실제는 %3개입니다. 나머지는 알 수 없습니다.</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>펄스</translation>
    </message>
    <message>
        <source>tool coordinates</source>
        <translation>툴 좌표</translation>
    </message>
    <message>
        <source>user coordinates</source>
        <translation>유저 좌표</translation>
    </message>
    <message>
        <source>master tool coordinates</source>
        <translation>마스터 툴 좌표</translation>
    </message>
</context>
<context>
    <name>dialogs::AccessSettingsDialog</name>
    <message>
        <source>Passcode and idle time</source>
        <translation>패스코드와 무조작 시간</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 분</translation>
    </message>
    <message>
        <source>Back to Monitor after</source>
        <translation>“모니터”로 돌아가기까지</translation>
    </message>
    <message>
        <source>New passcode</source>
        <translation>새 패스코드</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>다시 한 번 입력</translation>
    </message>
    <message>
        <source>Leave both empty for no passcode.</source>
        <translation>패스코드를 사용하지 않으려면 둘 다 비워 두십시오.</translation>
    </message>
    <message>
        <source>The two are not the same.</source>
        <translation>두 입력이 일치하지 않습니다.</translation>
    </message>
</context>
<context>
    <name>dialogs::AppearanceDialog</name>
    <message>
        <source>As the desktop</source>
        <translation>데스크톱 설정 따름</translation>
    </message>
    <message>
        <source>Language and look</source>
        <translation>언어와 모양</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>언어(&amp;L)</translation>
    </message>
    <message>
        <source>L&amp;ook</source>
        <translation>모양(&amp;O)</translation>
    </message>
    <message>
        <source>Words of the robot and text from the controller stay as they are on the pendant.</source>
        <translation>로봇의 용어와 컨트롤러의 텍스트는 펜던트의 표기 그대로 표시됩니다.</translation>
    </message>
</context>
<context>
    <name>dialogs::ApplyDialog</name>
    <message>
        <source>Variable</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>이전 값</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>새 값</translation>
    </message>
    <message>
        <source>Apply — %1</source>
        <translation>적용 — %1</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>쓰게 될 내용</translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s)</source>
        <translation>
            <numerusform>값 %n개 쓰기</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s) to %1</source>
        <translation>
            <numerusform>%1에 값 %n개 쓰기</numerusform>
        </translation>
    </message>
    <message>
        <source>Each is written once and read back. What does not read back as it was written stays here and is marked.</source>
        <translation>각 값을 한 번만 쓰고 다시 읽어 확인합니다. 쓴 대로 읽히지 않은 값은 여기에 남아 표시됩니다.</translation>
    </message>
</context>
<context>
    <name>dialogs::CompareDialog</name>
    <message>
        <source>Both are the same, byte for byte.</source>
        <translation>두 파일은 모든 바이트가 같습니다.</translation>
    </message>
</context>
<context>
    <name>dialogs::ConnectionDialog</name>
    <message>
        <source>Duplicate</source>
        <translation>복제</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>연결</translation>
    </message>
    <message>
        <source>Connect to a controller</source>
        <translation>컨트롤러에 연결</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Known controllers</source>
        <translation>등록된 컨트롤러</translation>
    </message>
    <message>
        <source>CONTROLLERS</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>Connecting only reads. HOLD: Pause key.</source>
        <translation>연결은 읽기만 합니다. HOLD: Pause 키.</translation>
    </message>
    <message>
        <source>A motion limit must be a number above 0, and each side of the box must begin before it ends.</source>
        <translation>동작 제한값은 0보다 큰 수이어야 하며, 허용 범위의 각 변은 하한이 상한보다 작아야 합니다.</translation>
    </message>
    <message>
        <source>There is another controller with the name “%1”.</source>
        <translation>이름이 “%1”인 다른 컨트롤러가 있습니다.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>New controller</source>
        <translation>새 컨트롤러</translation>
    </message>
</context>
<context>
    <name>dialogs::DiagnosisDialog</name>
    <message>
        <source>Diagnosis — %1</source>
        <translation>진단 — %1</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>진단 복사</translation>
    </message>
    <message>
        <source>The diagnosis is not finished yet.</source>
        <translation>진단이 아직 끝나지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>It only reads. HOLD works meanwhile: Pause key.</source>
        <translation>진단은 읽기만 합니다. 그동안에도 HOLD는 유효합니다: Pause 키.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>복사됨</translation>
    </message>
</context>
<context>
    <name>dialogs::HelpDialog</name>
    <message>
        <source>Help — %1</source>
        <translation>도움말 — %1</translation>
    </message>
    <message>
        <source>Search in this help</source>
        <translation>이 도움말에서 검색</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>이 단어가 포함된 내용이 없습니다.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>Keys of this page</source>
        <translation>이 페이지의 키</translation>
    </message>
    <message>
        <source>Keys everywhere</source>
        <translation>모든 페이지 공통 키</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>메뉴</translation>
    </message>
    <message>
        <source>Without a connection: connect to the controller on the filled button</source>
        <translation>연결되지 않은 경우: 채워진 버튼의 컨트롤러에 연결</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>페이지</translation>
    </message>
    <message>
        <source>Live: read within its last three turns.</source>
        <translation>실시간: 최근 3회의 읽기 주기 안에 읽었습니다.</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>오래됨</translation>
    </message>
    <message>
        <source>Stale: read once, too long ago. The tool tip says when. It is not what the robot does now.</source>
        <translation>오래됨: 한 번 읽었으나 너무 오래되었습니다. 언제 읽었는지는 툴팁에 표시됩니다. 로봇의 현재 상태가 아닙니다.</translation>
    </message>
    <message>
        <source>Unknown: not read on this connection. It is never shown as 0.</source>
        <translation>알 수 없음: 이번 연결에서 읽지 않았습니다. 0으로 표시되는 일은 없습니다.</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>거부됨</translation>
    </message>
    <message>
        <source>Refused: the controller does not tell it. The reason stands on the card or in the tool tip.</source>
        <translation>거부됨: 컨트롤러가 알려 주지 않습니다. 이유는 카드 또는 툴팁에 표시됩니다.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ON</translation>
    </message>
    <message>
        <source>A filled square: on, or 1.</source>
        <translation>채워진 사각형: ON 또는 1.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>A hollow square: off, or 0.</source>
        <translation>빈 사각형: OFF 또는 0.</translation>
    </message>
    <message>
        <source>held</source>
        <translation>홀드 중</translation>
    </message>
    <message>
        <source>An amber triangle: error, hold, something not allowed or to be looked at.</source>
        <translation>황색 삼각형: 에러, 홀드, 허용되지 않는 것 또는 확인이 필요한 것.</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>A red square: an alarm.</source>
        <translation>적색 사각형: 알람.</translation>
    </message>
    <message>
        <source>What the signs mean</source>
        <translation>기호의 의미</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>표시 예</translation>
    </message>
    <message>
        <source>An amber ground in a table: typed and staged, not sent yet. A red one: it reads back differently from what was written.</source>
        <translation>표의 황색 바탕: 입력하여 쓰기 예정이지만 아직 송신하지 않았습니다. 적색 바탕: 쓴 값과 다른 값이 읽혔습니다.</translation>
    </message>
</context>
<context>
    <name>dialogs::ImportDialog</name>
    <message>
        <source>Take over values — %1</source>
        <translation>값 가져오기 — %1</translation>
    </message>
    <message numerus="yes">
        <source>Stage %n value(s)</source>
        <translation>
            <numerusform>값 %n개를 쓰기 예정에 추가</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) would change</source>
        <translation>
            <numerusform>값 %n개가 바뀝니다</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are there already. Staging sends nothing to the controller.</source>
        <translation>
            <numerusform>값 %n개는 이미 같은 값입니다. 쓰기 예정에 추가해도 컨트롤러에는 아무것도 송신되지 않습니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) cannot be read, so nothing is taken over:</source>
        <translation>
            <numerusform>%n개 행을 읽을 수 없으므로 아무것도 가져오지 않습니다:</numerusform>
        </translation>
    </message>
    <message>
        <source>Lines that cannot be read</source>
        <translation>읽을 수 없는 행</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>행</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>잘못된 내용</translation>
    </message>
    <message>
        <source>Values that would change</source>
        <translation>바뀌는 값</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>이전 값</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>새 값</translation>
    </message>
</context>
<context>
    <name>dialogs::IoWriteDialog</name>
    <message>
        <source>Write %1 — %2</source>
        <translation>%1 쓰기 — %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>현재</translation>
    </message>
    <message>
        <source>Will be</source>
        <translation>쓰기 후</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The eight signals #%1 to #%2 travel together: all of them are written as they stand here.</source>
        <translation>8개 신호 #%1~#%2은(는) 함께 전송됩니다. 모두 여기에 표시된 대로 써집니다.</translation>
    </message>
    <message>
        <source>The group is being read…</source>
        <translation>그룹을 읽고 있습니다…</translation>
    </message>
    <message>
        <source>Written once, then read back.</source>
        <translation>한 번 쓴 후 다시 읽어 확인합니다.</translation>
    </message>
    <message>
        <source>Another of the eight has changed meanwhile. Nothing was sent: look again.</source>
        <translation>8개 중 다른 신호가 그사이에 변경되었습니다. 아무것도 송신하지 않았습니다. 다시 확인하십시오.</translation>
    </message>
    <message>
        <source>Being written…</source>
        <translation>쓰고 있습니다…</translation>
    </message>
    <message>
        <source>Written, and read back as it was written.</source>
        <translation>썼으며, 쓴 대로 다시 읽혔습니다.</translation>
    </message>
    <message>
        <source>Accepted, but another value was read back: %1. Something else writes these signals.</source>
        <translation>수락되었으나 다른 값이 읽혔습니다: %1. 다른 곳에서 이 신호에 쓰고 있습니다.</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>ON으로 하기</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>OFF로 하기</translation>
    </message>
</context>
<context>
    <name>dialogs::JobEditor</name>
    <message>
        <source>Edit “%1”</source>
        <translation>“%1” 편집</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>파일 내용</translation>
    </message>
    <message>
        <source>Compare and send…</source>
        <translation>비교 후 송신…</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding lacks a character of this text.</source>
        <translation>이 텍스트에 컨트롤러의 문자 코드에 없는 문자가 있습니다.</translation>
    </message>
</context>
<context>
    <name>dialogs::LadderView</name>
    <message>
        <source>passed</source>
        <translation>합격</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>불합격</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>미실시</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Pendesk %1, diagnosis of %2 (%3)</source>
        <translation>Pendesk %1, %2의 진단 (%3)</translation>
    </message>
</context>
<context>
    <name>dialogs::MotionForm</name>
    <message>
        <source>The tool point must stay in this box (base frame, mm)</source>
        <translation>제어점을 이 허용 범위 안으로 제한 (베이스 좌표, mm)</translation>
    </message>
    <message>
        <source>User and tool frames were checked on this robot</source>
        <translation>유저 좌표와 툴 좌표를 이 로봇에서 확인함</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>속도, mm/s</translation>
    </message>
    <message>
        <source>Rotation speed, °/s</source>
        <translation>회전 속도, °/s</translation>
    </message>
    <message>
        <source>Joint speed, %</source>
        <translation>관절 속도, %</translation>
    </message>
    <message>
        <source>Jog step, mm</source>
        <translation>조그 스텝, mm</translation>
    </message>
    <message>
        <source>Jog step, °</source>
        <translation>조그 스텝, °</translation>
    </message>
    <message>
        <source>Jog step, pulses</source>
        <translation>조그 스텝, 펄스</translation>
    </message>
    <message>
        <source>Descriptions disagree which code means the user and which the tool frame. Tick this only after a small move in both was watched at the robot.</source>
        <translation>어느 코드가 유저 좌표이고 어느 코드가 툴 좌표인지는 자료마다 다릅니다. 두 좌표에서의 작은 이동을 로봇 옆에서 보고 확인한 후에만 체크하십시오.</translation>
    </message>
    <message>
        <source>%1, as the program</source>
        <translation>%1 (이 프로그램의 기본값)</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>%1 하한</translation>
    </message>
    <message>
        <source>Most %1</source>
        <translation>%1 상한</translation>
    </message>
    <message>
        <source>%1 from, to</source>
        <translation>%1 하한, 상한</translation>
    </message>
</context>
<context>
    <name>dialogs::MoveSheet</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1 펄스</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Stop: HOLD</source>
        <translation>정지: HOLD</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Move at %1</source>
        <translation>이동 — %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>제어 그룹</translation>
    </message>
    <message>
        <source>From</source>
        <translation>출발 위치</translation>
    </message>
    <message>
        <source>To</source>
        <translation>목표 위치</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>경로</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>소요 시간</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>허용 범위</translation>
    </message>
    <message>
        <source>Stored points near the target</source>
        <translation>목표 부근의 등록점</translation>
    </message>
    <message>
        <source>A long move, or one that nobody can measure: type %1</source>
        <translation>긴 이동이거나 길이를 알 수 없는 이동입니다. %1 입력</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>키보드 사용 시: %1 입력 후 F9</translation>
    </message>
    <message>
        <source>HOLD stays on until it is released</source>
        <translation>HOLD는 해제할 때까지 유지됩니다</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>로봇이 움직입니다</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>알 수 없음</translation>
    </message>
    <message>
        <source>cannot be foretold in this frame</source>
        <translation>이 좌표에서는 예측할 수 없음</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>약 %1초</translation>
    </message>
    <message>
        <source>not known: a percentage of joint speed</source>
        <translation>알 수 없음: 관절 속도의 비율로 지정됨</translation>
    </message>
    <message>
        <source>not known: the target is in pulses</source>
        <translation>알 수 없음: 목표가 펄스로 지정됨</translation>
    </message>
    <message>
        <source>%1 mm and %2° between the ends; a joint move does not go straight</source>
        <translation>양 끝 사이 %1 mm, %2°. 관절 동작은 직선으로 움직이지 않습니다</translation>
    </message>
    <message>
        <source>%1 mm straight, turning %2°</source>
        <translation>직선 %1 mm, 회전 %2°</translation>
    </message>
    <message>
        <source>none is set for this controller</source>
        <translation>이 컨트롤러에는 설정되어 있지 않습니다</translation>
    </message>
    <message>
        <source>the whole way is inside</source>
        <translation>경로 전체가 범위 안에 있습니다</translation>
    </message>
    <message>
        <source>both ends are inside; the way between is not known</source>
        <translation>양 끝은 범위 안에 있습니다. 그 사이의 경로는 알 수 없습니다</translation>
    </message>
    <message>
        <source>%1, at most %2 %</source>
        <translation>%1, 최대 %2 %</translation>
    </message>
    <message>
        <source>%1, at most %2 mm/s</source>
        <translation>%1, 최대 %2 mm/s</translation>
    </message>
    <message>
        <source>%1, at most %2 °/s</source>
        <translation>%1, 최대 %2 °/s</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>비교할 수 없음</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 (거리 %2 mm)</translation>
    </message>
    <message>
        <source>none in the base frame was read</source>
        <translation>베이스 좌표의 등록점은 읽지 않았습니다</translation>
    </message>
    <message>
        <source>The robot is no longer where this move begins: close, and rehearse again.</source>
        <translation>로봇이 더 이상 이 이동의 출발 위치에 있지 않습니다. 닫고 사전 확인을 다시 하십시오.</translation>
    </message>
    <message>
        <source>Not sent: the place could not be read.</source>
        <translation>송신하지 않음: 위치를 읽을 수 없었습니다.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>a place that was not read</source>
        <translation>읽지 않은 위치</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>이동 중: %1</translation>
    </message>
    <message>
        <source>Move sent…</source>
        <translation>이동 송신됨…</translation>
    </message>
    <message>
        <source>Arrived: %1</source>
        <translation>도착: %1</translation>
    </message>
    <message>
        <source>Stopped at %1. That is not the target.</source>
        <translation>%1에서 정지했습니다. 목표 위치가 아닙니다.</translation>
    </message>
    <message>
        <source>At rest at %1. Whether that is the target cannot be told in this frame.</source>
        <translation>%1에 정지해 있습니다. 이 좌표에서는 목표 위치인지 알 수 없습니다.</translation>
    </message>
    <message>
        <source>No answer to the move: whether it was begun is unknown. It was sent once. Look at the robot.</source>
        <translation>이동에 대한 응답이 없습니다. 이동이 시작되었는지 알 수 없습니다. 한 번 송신했습니다. 로봇을 확인하십시오.</translation>
    </message>
    <message>
        <source>The outcome is unknown: communication was lost, or it does not come to rest. Look at the robot.</source>
        <translation>결과를 알 수 없습니다. 통신이 끊어졌거나 로봇이 정지하지 않습니다. 로봇을 확인하십시오.</translation>
    </message>
</context>
<context>
    <name>dialogs::NumberingDialog</name>
    <message>
        <source>Variable numbering — %1</source>
        <translation>변수 번호 방식 — %1</translation>
    </message>
    <message>
        <source>Number of the variable</source>
        <translation>변수 번호</translation>
    </message>
    <message>
        <source>Value on the pendant</source>
        <translation>펜던트의 값</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>아직 읽지 않음</translation>
    </message>
    <message>
        <source>reads on the pendant</source>
        <translation>의 펜던트 표시값은</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>Keep the result</source>
        <translation>결과 저장</translation>
    </message>
    <message>
        <source>Which number is which?</source>
        <translation>어느 번호가 어느 변수입니까?</translation>
    </message>
    <message>
        <source>Parameter RS022 decides whether B000 is number 0 or number 1 on the network. Until that is known, a write could hit the neighbour, so none is sent. Read two variables on the pendant (main menu, VARIABLE, BYTE) and enter what you see. This test only reads.</source>
        <translation>파라미터 RS022는 네트워크에서 B000이 번호 0인지 번호 1인지를 정합니다. 이를 알기 전에는 쓰기가 인접한 변수에 적용될 수 있으므로 아무것도 송신하지 않습니다. 펜던트에서 변수 2개를 읽고 (메인 메뉴, VARIABLE, BYTE) 표시된 값을 입력하십시오. 이 테스트는 읽기만 합니다.</translation>
    </message>
    <message>
        <source>The variables could not be read: %1.</source>
        <translation>변수를 읽을 수 없었습니다: %1.</translation>
    </message>
    <message>
        <source>All B variables hold the same value, which proves nothing: let a job or the pendant set B010 to 1 and B011 to 2, then open this test again.</source>
        <translation>모든 B 변수가 같은 값이므로 판별할 수 없습니다. 잡 또는 펜던트로 B010을 1로, B011을 2로 설정한 후 이 테스트를 다시 여십시오.</translation>
    </message>
    <message>
        <source>These two tell the numberings apart.</source>
        <translation>이 두 변수로 번호 방식을 판별할 수 있습니다.</translation>
    </message>
    <message>
        <source>Verified: number 0 on the network is B000.</source>
        <translation>대조됨: 네트워크의 번호 0이 B000입니다.</translation>
    </message>
    <message>
        <source>Verified, shifted: number 1 on the network is B000.</source>
        <translation>대조됨, 어긋남 있음: 네트워크의 번호 1이 B000입니다.</translation>
    </message>
    <message>
        <source>Both numberings fit these values: choose variables whose neighbours hold other values.</source>
        <translation>두 방식 모두 이 값에 맞습니다. 인접한 변수의 값이 서로 다른 변수를 선택하십시오.</translation>
    </message>
    <message>
        <source>Neither numbering fits: read the values again, they may have changed.</source>
        <translation>어느 방식에도 맞지 않습니다. 값이 바뀌었을 수 있으므로 다시 읽으십시오.</translation>
    </message>
</context>
<context>
    <name>dialogs::OverwriteDialog</name>
    <message numerus="yes">
        <source>For the remaining %n file(s) too</source>
        <translation>
            <numerusform>나머지 파일 %n개에도 적용</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” exists</source>
        <translation>“%1”이(가) 이미 있습니다</translation>
    </message>
    <message>
        <source>There is a file “%1” %2 already.</source>
        <translation>%2에 파일 “%1”이(가) 이미 있습니다.</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>비교(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>바꾸기(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keep both</source>
        <translation>둘 다 유지(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>건너뛰기(&amp;S)</translation>
    </message>
</context>
<context>
    <name>dialogs::PasscodeDialog</name>
    <message>
        <source>The passcode guards against mistakes, not against attackers: whoever can change this user&apos;s files can remove it.</source>
        <translation>패스코드는 실수를 막기 위한 것이며 공격을 막지는 못합니다. 이 사용자의 파일을 변경할 수 있는 사람은 누구나 제거할 수 있습니다.</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>액세스 레벨: %1</translation>
    </message>
    <message>
        <source>Passcode</source>
        <translation>패스코드</translation>
    </message>
    <message>
        <source>That is not the passcode.</source>
        <translation>패스코드가 맞지 않습니다.</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>확인 중…</translation>
    </message>
</context>
<context>
    <name>dialogs::PositionDialog</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>타입</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>쓰기 예정에 추가</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 또는 %2</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>툴</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>유저 좌표</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>형태</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>확장 형태</translation>
    </message>
    <message>
        <source>Take the present position of R1 (base frame)</source>
        <translation>R1의 현재 위치 가져오기 (베이스 좌표)</translation>
    </message>
    <message>
        <source>Take R1 in pulses</source>
        <translation>R1을 펄스로 가져오기</translation>
    </message>
    <message>
        <source>Take the present position of B1 (base frame)</source>
        <translation>B1의 현재 위치 가져오기 (베이스 좌표)</translation>
    </message>
    <message>
        <source>Take B1 in pulses</source>
        <translation>B1을 펄스로 가져오기</translation>
    </message>
    <message>
        <source>Take the present position of S1</source>
        <translation>S1의 현재 위치 가져오기</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>실시간: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A user-frame position needs a user frame from 1 to 63.</source>
        <translation>유저 좌표의 위치에는 1부터 63까지의 유저 좌표 번호가 필요합니다.</translation>
    </message>
    <message>
        <source>Sources disagree which code means user and which means tool frame: check on the pendant before a job uses this position.</source>
        <translation>어느 코드가 유저 좌표이고 어느 코드가 툴 좌표인지 자료마다 다릅니다. 잡에서 이 위치를 사용하기 전에 펜던트에서 확인하십시오.</translation>
    </message>
    <message>
        <source>The position is being read…</source>
        <translation>위치를 읽고 있습니다…</translation>
    </message>
    <message>
        <source>The position could not be read: %1.</source>
        <translation>위치를 읽을 수 없었습니다: %1.</translation>
    </message>
</context>
<context>
    <name>dialogs::ProfileForm</name>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Host name or address</source>
        <translation>호스트 이름 또는 주소</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>기종</translation>
    </message>
    <message>
        <source>Text encoding</source>
        <translation>문자 코드</translation>
    </message>
    <message>
        <source>Variable numbering</source>
        <translation>변수 번호 방식</translation>
    </message>
    <message>
        <source>B000 is number 0 on the wire</source>
        <translation>B000은 통신상 번호 0</translation>
    </message>
    <message>
        <source>B000 is number 1 on the wire</source>
        <translation>B000은 통신상 번호 1</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>포트</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>파일 포트</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>읽기 타임아웃</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>파일 타임아웃</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>서보 타임아웃</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>읽기 재시도 횟수</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>동시에 응답을 기다리는 요청 수</translation>
    </message>
    <message>
        <source>Requests a second, at most</source>
        <translation>초당 최대 요청 수</translation>
    </message>
    <message>
        <source>Jog and move, at most</source>
        <translation>조그와 이동의 상한</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>%1부터 %2까지</translation>
    </message>
</context>
<context>
    <name>dialogs::ReadinessSheet</name>
    <message>
        <source>Readiness — %1</source>
        <translation>준비 상태 — %1</translation>
    </message>
    <message>
        <source>What %1 allows now</source>
        <translation>%1에서 현재 허용되는 것</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>준비 상태</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Copy the readiness and a diagnosis</source>
        <translation>준비 상태와 진단 복사</translation>
    </message>
    <message>
        <source>As text for support, with a diagnosis of the link, which takes a moment.</source>
        <translation>지원용 텍스트로 복사합니다. 통신 진단을 포함하며 잠시 시간이 걸립니다.</translation>
    </message>
    <message>
        <source>Test numbering…</source>
        <translation>번호 방식 대조…</translation>
    </message>
    <message>
        <source>It needs a link to the controller.</source>
        <translation>컨트롤러와의 통신이 필요합니다.</translation>
    </message>
    <message>
        <source>Communication lost at %1: what is hatched was read before.</source>
        <translation>%1에 통신이 끊어졌습니다. 빗금으로 표시된 것은 그 전에 읽은 것입니다.</translation>
    </message>
    <message>
        <source>%1 has not answered yet.</source>
        <translation>%1이(가) 아직 응답하지 않았습니다.</translation>
    </message>
    <message>
        <source>Not connected: nothing is read.</source>
        <translation>연결되지 않음: 아무것도 읽지 않습니다.</translation>
    </message>
    <message>
        <source>The status was not read just now.</source>
        <translation>상태가 최신이 아닙니다.</translation>
    </message>
    <message>
        <source>It is read live and changes nothing. HOLD works meanwhile: Pause key.</source>
        <translation>실시간으로 읽으며 아무것도 변경하지 않습니다. 그동안에도 HOLD는 유효합니다: Pause 키.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>복사됨</translation>
    </message>
</context>
<context>
    <name>dialogs::RestoreDialog</name>
    <message>
        <source>Put that file back</source>
        <translation>그 파일을 원래대로 되돌리기</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Restore %1 from %2</source>
        <translation>%2에서 %1 복원</translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation>실행될 내용</translation>
    </message>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>처리</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>+ new: it is sent</source>
        <translation>+ 신규: 송신합니다</translation>
    </message>
    <message>
        <source>≠ changed: it is replaced</source>
        <translation>≠ 변경됨: 바꿉니다</translation>
    </message>
    <message>
        <source>= same: left alone</source>
        <translation>= 같음: 그대로 둡니다</translation>
    </message>
    <message>
        <source>▲ not allowed: left alone</source>
        <translation>▲ 허용되지 않음: 그대로 둡니다</translation>
    </message>
    <message numerus="yes">
        <source>Back up, then restore %n file(s)</source>
        <translation>
            <numerusform>백업 후 파일 %n개 복원</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are the same and not listed.</source>
        <translation>
            <numerusform>파일 %n개는 같으므로 표시하지 않습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Sending file %1 of %2…</source>
        <translation>파일 송신 중 (%1 / %2)…</translation>
    </message>
    <message>
        <source>Fresh backup: file %1 of %2…</source>
        <translation>새 백업: 파일 %1 / %2…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored and read back.</source>
        <translation>
            <numerusform>파일 %n개를 복원하고 다시 읽어 확인했습니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored before that.</source>
        <translation>
            <numerusform>그 전에 파일 %n개를 복원했습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>취소되었습니다.</translation>
    </message>
    <message>
        <source>Stopped at %1.</source>
        <translation>%1에서 중지했습니다.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>아무것도 송신하지 않았습니다.</translation>
    </message>
    <message>
        <source>The file is as it was before.</source>
        <translation>파일은 이전 그대로입니다.</translation>
    </message>
    <message>
        <source>▲ The file could not be put back. Look at the controller.</source>
        <translation>▲ 파일을 원래대로 되돌릴 수 없었습니다. 컨트롤러를 확인하십시오.</translation>
    </message>
    <message>
        <source>A fresh backup of %1 is made first. Then the files below are sent one by one and read back. A refused file is left out; it stops at any other error.</source>
        <translation>먼저 %1의 새 백업을 만듭니다. 그다음 아래 파일을 하나씩 송신하고 다시 읽어 확인합니다. 거부된 파일은 건너뛰며, 그 외의 에러에서는 중지합니다.</translation>
    </message>
    <message>
        <source>%1: the backup is of %2, the controller is %3.</source>
        <translation>%1: 백업은 %2, 컨트롤러는 %3입니다.</translation>
    </message>
    <message>
        <source>This is the backup of another robot: nothing of it is sent.</source>
        <translation>다른 로봇의 백업입니다. 아무것도 송신하지 않습니다.</translation>
    </message>
    <message>
        <source>The controller refused %1; the other files were sent.</source>
        <translation>컨트롤러가 %1을(를) 거부했습니다. 다른 파일은 송신되었습니다.</translation>
    </message>
</context>
<context>
    <name>dialogs::SignalPicker</name>
    <message>
        <source>Add a signal</source>
        <translation>신호 추가</translation>
    </message>
    <message>
        <source>For example: R1 torque, B005, #00010, M012</source>
        <translation>예: R1 토크, B005, #00010, M012</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>검색</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>신호</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
</context>
<context>
    <name>dialogs::StartSheet</name>
    <message>
        <source>Start</source>
        <translation>기동</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Start at %1</source>
        <translation>기동 — %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>시작 행</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>사이클</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>속도 오버라이드</translation>
    </message>
    <message>
        <source>HOLD: Pause key</source>
        <translation>HOLD: Pause 키</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>로봇이 움직입니다</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>키보드 사용 시: %1 입력 후 F9</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Start sent…</source>
        <translation>기동 송신됨…</translation>
    </message>
    <message>
        <source>Accepted. Waiting for RUN…</source>
        <translation>수락되었습니다. RUN을 기다리고 있습니다…</translation>
    </message>
    <message>
        <source>The start was accepted, but no RUN was seen for 3 s. Usual causes: the job was so short that it has ended, it waits for a condition of the cell, or the pendant shows a question. Look at the pendant.</source>
        <translation>기동은 수락되었으나 3초 동안 RUN이 확인되지 않았습니다. 일반적인 원인: 잡이 짧아 이미 끝났거나, 셀의 조건을 기다리고 있거나, 펜던트에 확인 메시지가 표시되어 있습니다. 펜던트를 확인하십시오.</translation>
    </message>
    <message>
        <source>No answer to the start: it may or may not have happened. Reading the status…</source>
        <translation>기동에 대한 응답이 없습니다. 실행되었을 수도 있고 실행되지 않았을 수도 있습니다. 상태를 읽고 있습니다…</translation>
    </message>
    <message>
        <source>No answer to the start, and none to the status: whether the robot runs is unknown. Look at it.</source>
        <translation>기동에 대한 응답도 상태에 대한 응답도 없습니다. 로봇이 운전 중인지 알 수 없습니다. 로봇을 확인하십시오.</translation>
    </message>
    <message>
        <source>No answer to the start, but a status that was read afterwards said RUN. It was sent once.</source>
        <translation>기동에 대한 응답은 없으나 그 후 읽은 상태는 RUN이었습니다. 한 번 송신했습니다.</translation>
    </message>
    <message>
        <source>No answer to the start, and a status that was read afterwards said no RUN. Look at the robot before you start again.</source>
        <translation>기동에 대한 응답이 없고 그 후 읽은 상태는 RUN이 아니었습니다. 다시 기동하기 전에 로봇을 확인하십시오.</translation>
    </message>
</context>
<context>
    <name>dialogs::WhyNotDialog</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>조건</translation>
    </message>
    <message>
        <source>What must be the case</source>
        <translation>필요한 조건</translation>
    </message>
</context>
<context>
    <name>files::Identity</name>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>호스트</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>기종</translation>
    </message>
    <message>
        <source>Robots and axes</source>
        <translation>로봇과 축</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>소프트웨어</translation>
    </message>
    <message>
        <source>Number of variables</source>
        <translation>변수의 수</translation>
    </message>
</context>
<context>
    <name>files::Restore</name>
    <message>
        <source>It is not in the backup.</source>
        <translation>백업에 없습니다.</translation>
    </message>
    <message>
        <source>What the controller has could not be read.</source>
        <translation>컨트롤러에 있는 내용을 읽을 수 없었습니다.</translation>
    </message>
    <message>
        <source>In the backup it is not as it was written.</source>
        <translation>백업의 내용이 썼을 때와 다릅니다.</translation>
    </message>
    <message>
        <source>It belongs to this one controller, or only tells what happened: it is never sent.</source>
        <translation>이 컨트롤러 한 대에만 속하거나 발생한 일만 기록하므로 송신되는 일은 없습니다.</translation>
    </message>
    <message>
        <source>It comes from another robot.</source>
        <translation>다른 로봇의 것입니다.</translation>
    </message>
    <message>
        <source>It changes how the robot moves, or what protects people: look at the differences and choose it.</source>
        <translation>로봇의 동작 방식이나 사람을 보호하는 기능을 변경합니다. 차이를 확인한 후 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>files::Verify</name>
    <message>
        <source>This is no backup: %1 is missing or of another kind.</source>
        <translation>백업이 아닙니다. %1이(가) 없거나 다른 종류입니다.</translation>
    </message>
    <message>
        <source>%1 is not as it was written.</source>
        <translation>%1이(가) 썼을 때와 다릅니다.</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1이(가) 변경되었습니다.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>%1 does not belong to the backup.</source>
        <translation>%1은(는) 이 백업에 속하지 않습니다.</translation>
    </message>
</context>
<context>
    <name>inform::Check</name>
    <message>
        <source>The file is empty.</source>
        <translation>파일이 비어 있습니다.</translation>
    </message>
    <message>
        <source>HSES cannot carry it.</source>
        <translation>HSES로는 전송할 수 없습니다.</translation>
    </message>
    <message>
        <source>“%1” is no type of file that can be sent.</source>
        <translation>“%1”은(는) 송신할 수 있는 파일 형식이 아닙니다.</translation>
    </message>
    <message>
        <source>Controllers take JBI, JBR, CND, DAT, PRM and LST.</source>
        <translation>컨트롤러는 JBI, JBR, CND, DAT, PRM, LST를 받습니다.</translation>
    </message>
    <message>
        <source>The type of the file is written in small letters.</source>
        <translation>파일 형식이 소문자로 되어 있습니다.</translation>
    </message>
    <message>
        <source>Controllers write it in capitals.</source>
        <translation>컨트롤러는 대문자로 씁니다.</translation>
    </message>
    <message>
        <source>The header names the job “%1”.</source>
        <translation>헤더의 잡 이름은 “%1”입니다.</translation>
    </message>
    <message>
        <source>The name in the header counts: that job would be written.</source>
        <translation>헤더의 이름이 기준입니다. 그 잡에 쓰게 됩니다.</translation>
    </message>
    <message>
        <source>The job is being executed.</source>
        <translation>잡이 실행 중입니다.</translation>
    </message>
    <message>
        <source>A running job cannot be replaced.</source>
        <translation>실행 중인 잡은 바꿀 수 없습니다.</translation>
    </message>
    <message>
        <source>All names in the controller become those in this file.</source>
        <translation>컨트롤러의 모든 이름이 이 파일의 이름으로 바뀝니다.</translation>
    </message>
    <message>
        <source>Back them up first.</source>
        <translation>먼저 백업하십시오.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark.</source>
        <translation>파일이 바이트 순서 표시(BOM)로 시작합니다.</translation>
    </message>
    <message>
        <source>Controllers know no such mark: save the file without it.</source>
        <translation>컨트롤러는 이 표시를 알지 못합니다. 표시 없이 파일을 저장하십시오.</translation>
    </message>
    <message>
        <source>The file is UTF-16 text.</source>
        <translation>UTF-16 텍스트 파일입니다.</translation>
    </message>
    <message>
        <source>Controllers take one byte for a letter.</source>
        <translation>컨트롤러에서 영문자는 1바이트입니다.</translation>
    </message>
    <message>
        <source>The lines end in CR alone.</source>
        <translation>행 끝이 CR뿐입니다.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (pendant 3200).</source>
        <translation>행 끝은 CR LF이어야 합니다. 컨트롤러가 NOP도 END도 찾지 못합니다 (펜던트 3200).</translation>
    </message>
    <message>
        <source>Lines end in LF alone.</source>
        <translation>행 끝이 LF뿐입니다.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (0x5130, pendant 3200).</source>
        <translation>행 끝은 CR LF이어야 합니다. 컨트롤러가 NOP도 END도 찾지 못합니다 (0x5130, 펜던트 3200).</translation>
    </message>
    <message>
        <source>Lines end in CR LF; a controller may read such a file as empty.</source>
        <translation>행 끝은 CR LF이어야 합니다. 컨트롤러가 이런 파일을 빈 파일로 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>The last line does not end.</source>
        <translation>마지막 행에 행 끝이 없습니다.</translation>
    </message>
    <message>
        <source>Controllers end each line in CR LF.</source>
        <translation>컨트롤러는 각 행을 CR LF로 끝냅니다.</translation>
    </message>
    <message>
        <source>There is a Ctrl-Z at the end.</source>
        <translation>끝에 Ctrl-Z가 있습니다.</translation>
    </message>
    <message>
        <source>It stands behind END, which must be last (0x5130).</source>
        <translation>END 뒤에 있습니다. END가 마지막이어야 합니다 (0x5130).</translation>
    </message>
    <message>
        <source>There is a control character.</source>
        <translation>제어 문자가 있습니다.</translation>
    </message>
    <message>
        <source>No line of a job may have one.</source>
        <translation>잡의 행에는 제어 문자가 있을 수 없습니다.</translation>
    </message>
    <message>
        <source>This is no job: it does not have the line /JOB.</source>
        <translation>잡이 아닙니다. /JOB 행이 없습니다.</translation>
    </message>
    <message>
        <source>A job begins with it (0x5310).</source>
        <translation>잡은 이 행으로 시작합니다 (0x5310).</translation>
    </message>
    <message>
        <source>The file holds more than one job.</source>
        <translation>파일에 잡이 2개 이상 있습니다.</translation>
    </message>
    <message>
        <source>Only the first one was looked at.</source>
        <translation>첫 번째 잡만 검사했습니다.</translation>
    </message>
    <message>
        <source>“%1” is no name for a job.</source>
        <translation>“%1”은(는) 잡 이름으로 사용할 수 없습니다.</translation>
    </message>
    <message>
        <source>A name has 1 to 32 bytes, no blanks and none of the signs that names of files may not have (0x4190).</source>
        <translation>이름은 1~32바이트이며, 공백과 파일 이름에 쓸 수 없는 기호를 사용할 수 없습니다 (0x4190).</translation>
    </message>
    <message>
        <source>There is text that belongs to no section.</source>
        <translation>어느 섹션에도 속하지 않는 텍스트가 있습니다.</translation>
    </message>
    <message>
        <source>It is no INFORM (0x5310).</source>
        <translation>INFORM이 아닙니다 (0x5310).</translation>
    </message>
    <message>
        <source>%1 is no known pseudo instruction.</source>
        <translation>%1은(는) 알려진 의사 명령이 아닙니다.</translation>
    </message>
    <message>
        <source>A controller that does not know it refuses the file (0x5340).</source>
        <translation>이를 알지 못하는 컨트롤러는 파일을 거부합니다 (0x5340).</translation>
    </message>
    <message>
        <source>The comment of the job is longer than 32 bytes.</source>
        <translation>잡의 코멘트가 32바이트보다 깁니다.</translation>
    </message>
    <message>
        <source>Controllers cut it or refuse it.</source>
        <translation>컨트롤러가 잘라 내거나 거부합니다.</translation>
    </message>
    <message>
        <source>A frame is given, and the attribute RJ is missing.</source>
        <translation>좌표가 지정되어 있으나 속성 RJ가 없습니다.</translation>
    </message>
    <message>
        <source>Only relative jobs have a frame (0x4490).</source>
        <translation>상대 잡에만 좌표가 있습니다 (0x4490).</translation>
    </message>
    <message>
        <source>The job is relative, and no frame is given.</source>
        <translation>상대 잡이지만 좌표가 지정되지 않았습니다.</translation>
    </message>
    <message>
        <source>A relative job names its frame (0x3390).</source>
        <translation>상대 잡은 좌표를 지정해야 합니다 (0x3390).</translation>
    </message>
    <message>
        <source>There are positions, and no ///NPOS that counts them.</source>
        <translation>위치가 있으나 그 수를 나타내는 ///NPOS가 없습니다.</translation>
    </message>
    <message>
        <source>The controller compares them (0x5180).</source>
        <translation>컨트롤러는 둘을 비교합니다 (0x5180).</translation>
    </message>
    <message>
        <source>///NPOS does not count the positions of each kind: %1 (kind, said, found).</source>
        <translation>///NPOS의 종류별 위치 수가 맞지 않습니다: %1 (종류, 지정, 실제).</translation>
    </message>
    <message>
        <source>There is text among the positions that is none.</source>
        <translation>위치 사이에 위치가 아닌 텍스트가 있습니다.</translation>
    </message>
    <message>
        <source>Every line of //POS is a position or a pseudo instruction (0x5120).</source>
        <translation>//POS의 모든 행은 위치 또는 의사 명령입니다 (0x5120).</translation>
    </message>
    <message>
        <source>%1 is there twice.</source>
        <translation>%1이(가) 2개 있습니다.</translation>
    </message>
    <message>
        <source>Each position has one entry (0x5120).</source>
        <translation>위치마다 항목은 하나입니다 (0x5120).</translation>
    </message>
    <message>
        <source>%1 is named by no line.</source>
        <translation>%1을(를) 사용하는 행이 없습니다.</translation>
    </message>
    <message>
        <source>Each taught point belongs to one instruction (pendant 3190).</source>
        <translation>티칭된 점은 각각 하나의 명령에 속합니다 (펜던트 3190).</translation>
    </message>
    <message>
        <source>%1 has no entry among the positions.</source>
        <translation>위치에 %1의 항목이 없습니다.</translation>
    </message>
    <message>
        <source>The robot would not know where to go (0x4130).</source>
        <translation>로봇이 이동할 위치를 알 수 없습니다 (0x4130).</translation>
    </message>
    <message>
        <source>%1 is named in two places.</source>
        <translation>%1이(가) 두 곳에서 사용됩니다.</translation>
    </message>
    <message>
        <source>Controllers give each place a point of its own.</source>
        <translation>컨트롤러는 각 위치에 별도의 점을 부여합니다.</translation>
    </message>
    <message>
        <source>The number of values does not fit the axes: %1 (position, values).</source>
        <translation>값의 수가 축과 맞지 않습니다: %1 (위치, 값).</translation>
    </message>
    <message>
        <source>A robot has 6 or 7 axes, a base 1 to 3, a station 1 to 6 (0x5180).</source>
        <translation>로봇은 6축 또는 7축, 베이스는 1~3축, 스테이션은 1~6축입니다 (0x5180).</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1에 숫자가 아닌 값이 있습니다.</translation>
    </message>
    <message>
        <source>The controller cannot read it (0x5120).</source>
        <translation>컨트롤러가 읽을 수 없습니다 (0x5120).</translation>
    </message>
    <message>
        <source>The line ///PULSE, ///RECTAN or ///ANGLE before %1 does not fit its ///POSTYPE.</source>
        <translation>%1 앞의 ///PULSE, ///RECTAN 또는 ///ANGLE 행이 그 ///POSTYPE과 맞지 않습니다.</translation>
    </message>
    <message>
        <source>PULSE goes with ///PULSE, ANGLE with ///ANGLE, the others with ///RECTAN (0x5120).</source>
        <translation>PULSE에는 ///PULSE, ANGLE에는 ///ANGLE, 나머지에는 ///RECTAN을 씁니다 (0x5120).</translation>
    </message>
    <message>
        <source>%1 is in pulses, and the job is relative.</source>
        <translation>%1은(는) 펄스로 되어 있으나 상대 잡입니다.</translation>
    </message>
    <message>
        <source>The points of a relative job stand in its frame.</source>
        <translation>상대 잡의 점은 그 좌표로 나타냅니다.</translation>
    </message>
    <message>
        <source>There are taught points (%1), and the job has no control group.</source>
        <translation>티칭된 점(%1)이 있으나 잡에 제어 그룹이 없습니다.</translation>
    </message>
    <message>
        <source>A job without a group cannot move (0x5430).</source>
        <translation>그룹이 없는 잡은 움직일 수 없습니다 (0x5430).</translation>
    </message>
    <message>
        <source>There are %1 points, and no control group of the job has such axes.</source>
        <translation>%1 점이 있으나 잡의 제어 그룹에 그런 축이 없습니다.</translation>
    </message>
    <message>
        <source>C needs a robot, BC a base, EC a station among the groups (0x3370).</source>
        <translation>그룹 중에 C에는 로봇, BC에는 베이스, EC에는 스테이션이 필요합니다 (0x3370).</translation>
    </message>
    <message>
        <source>The first instruction is not NOP.</source>
        <translation>첫 명령이 NOP가 아닙니다.</translation>
    </message>
    <message>
        <source>Every job begins with NOP (0x5130, pendant 3200).</source>
        <translation>모든 잡은 NOP로 시작합니다 (0x5130, 펜던트 3200).</translation>
    </message>
    <message>
        <source>The last instruction is not END.</source>
        <translation>마지막 명령이 END가 아닙니다.</translation>
    </message>
    <message>
        <source>Every job ends with END (0x5130, pendant 3200).</source>
        <translation>모든 잡은 END로 끝납니다 (0x5130, 펜던트 3200).</translation>
    </message>
    <message>
        <source>There is an END before the last line.</source>
        <translation>마지막 행 앞에 END가 있습니다.</translation>
    </message>
    <message>
        <source>What follows it is no job (0x5130).</source>
        <translation>그 뒤의 내용은 잡이 아닙니다 (0x5130).</translation>
    </message>
    <message>
        <source>The line begins with no instruction.</source>
        <translation>행이 명령으로 시작하지 않습니다.</translation>
    </message>
    <message>
        <source>An instruction was cut in two: it belongs to the line before (0x5110).</source>
        <translation>명령이 둘로 나뉘었습니다. 앞 행에 속합니다 (0x5110).</translation>
    </message>
    <message>
        <source>%1 is no instruction that this program knows.</source>
        <translation>%1은(는) 이 프로그램이 아는 명령이 아닙니다.</translation>
    </message>
    <message>
        <source>It may belong to an option; a controller without it refuses the job (0x5110).</source>
        <translation>옵션의 명령일 수 있습니다. 옵션이 없는 컨트롤러는 잡을 거부합니다 (0x5110).</translation>
    </message>
    <message>
        <source>There are characters beyond ASCII outside of comments and texts.</source>
        <translation>코멘트와 텍스트 이외 부분에 ASCII가 아닌 문자가 있습니다.</translation>
    </message>
    <message>
        <source>Instructions are ASCII.</source>
        <translation>명령은 ASCII입니다.</translation>
    </message>
    <message>
        <source>There is an empty line among the instructions.</source>
        <translation>명령 사이에 빈 행이 있습니다.</translation>
    </message>
    <message>
        <source>Controllers write none.</source>
        <translation>컨트롤러는 빈 행을 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>The job has more than 10,000 lines.</source>
        <translation>잡이 10,000행보다 깁니다.</translation>
    </message>
    <message>
        <source>Controllers number lines to 9999.</source>
        <translation>컨트롤러의 행 번호는 9999까지입니다.</translation>
    </message>
    <message>
        <source>A comment or message is longer than 32 bytes.</source>
        <translation>코멘트 또는 메시지가 32바이트보다 깁니다.</translation>
    </message>
    <message>
        <source>Controllers cut it.</source>
        <translation>컨트롤러가 잘라 냅니다.</translation>
    </message>
    <message>
        <source>The label *%1 is longer than 8 bytes.</source>
        <translation>라벨 *%1이(가) 8바이트보다 깁니다.</translation>
    </message>
    <message>
        <source>Labels have 1 to 8 (0x4200).</source>
        <translation>라벨은 1~8바이트입니다 (0x4200).</translation>
    </message>
    <message>
        <source>The label *%1 is there twice.</source>
        <translation>라벨 *%1이(가) 2개 있습니다.</translation>
    </message>
    <message>
        <source>A jump would have two goals (0x4200).</source>
        <translation>점프의 목적지가 2개가 됩니다 (0x4200).</translation>
    </message>
    <message>
        <source>There is no label *%1.</source>
        <translation>라벨 *%1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>The jump gives an alarm when it is executed.</source>
        <translation>점프를 실행하면 알람이 발생합니다.</translation>
    </message>
    <message>
        <source>%1 is not closed.</source>
        <translation>%1이(가) 닫히지 않았습니다.</translation>
    </message>
    <message>
        <source>IFTHEN needs ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</source>
        <translation>IFTHEN에는 ENDIF, WHILE에는 ENDWHILE, FOR에는 NEXT, SWITCH에는 ENDSWITCH가 필요합니다 (0x5110).</translation>
    </message>
    <message>
        <source>%1 stands outside of what it belongs to.</source>
        <translation>%1이(가) 속해야 할 구조의 밖에 있습니다.</translation>
    </message>
    <message>
        <source>Structures are closed in the reverse order (0x5110).</source>
        <translation>구조는 역순으로 닫습니다 (0x5110).</translation>
    </message>
    <message>
        <source>Structures are nested more than 10 deep.</source>
        <translation>구조의 중첩이 10단계를 넘습니다.</translation>
    </message>
    <message>
        <source>Controllers allow 10.</source>
        <translation>컨트롤러는 10단계까지 허용합니다.</translation>
    </message>
    <message>
        <source>%1 is out of range.</source>
        <translation>%1이(가) 범위를 벗어났습니다.</translation>
    </message>
    <message>
        <source>The controller may refuse it (0x5200).</source>
        <translation>컨트롤러가 거부할 수 있습니다 (0x5200).</translation>
    </message>
    <message>
        <source>There are more than 8 arguments.</source>
        <translation>인수가 8개보다 많습니다.</translation>
    </message>
    <message>
        <source>A job takes 8 (0x5110).</source>
        <translation>잡의 인수는 8개까지입니다 (0x5110).</translation>
    </message>
    <message>
        <source>%1 is beyond what ///LVARS provides.</source>
        <translation>%1이(가) ///LVARS의 범위를 벗어났습니다.</translation>
    </message>
    <message>
        <source>The job has fewer local variables (0x5110).</source>
        <translation>잡의 로컬 변수가 그보다 적습니다 (0x5110).</translation>
    </message>
    <message>
        <source>Line %1 of the file, named by line %2: %3</source>
        <translation>파일의 행 %1 (행 %2에서 사용): %3</translation>
    </message>
    <message>
        <source>Line %1 (%2 in the file): %3</source>
        <translation>행 %1 (파일에서는 행 %2): %3</translation>
    </message>
    <message>
        <source>Line %1 of the file: %2</source>
        <translation>파일의 행 %1: %2</translation>
    </message>
    <message>
        <source>There is no ///NPOS.</source>
        <translation>///NPOS가 없습니다.</translation>
    </message>
</context>
<context>
    <name>inform::JobDiff</name>
    <message>
        <source>arm form: field %1 of RCONF %2 → %3</source>
        <translation>암 형태: RCONF의 항목 %1 %2 → %3</translation>
    </message>
    <message>
        <source>arm form: %1 → %2</source>
        <translation>암 형태: %1 → %2</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>축 %1</translation>
    </message>
    <message>
        <source>%1 pulses in %2</source>
        <translation>%2 %1 펄스</translation>
    </message>
    <message>
        <source>%1 mm in %2</source>
        <translation>%2 %1 mm</translation>
    </message>
    <message>
        <source>%1° in %2</source>
        <translation>%2 %1°</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>합계 %1</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>이동됨: %1</translation>
    </message>
    <message>
        <source>moved %1 (%2)</source>
        <translation>이동됨: %1 (%2)</translation>
    </message>
    <message>
        <source>type %1 → %2</source>
        <translation>타입 %1 → %2</translation>
    </message>
    <message>
        <source>tool %1 → %2</source>
        <translation>툴 %1 → %2</translation>
    </message>
    <message>
        <source>user frame %1 → %2</source>
        <translation>유저 좌표 %1 → %2</translation>
    </message>
    <message>
        <source>marked as beyond the limit</source>
        <translation>리밋 초과로 표시됨</translation>
    </message>
    <message>
        <source>no longer marked as beyond the limit</source>
        <translation>더 이상 리밋 초과로 표시되지 않음</translation>
    </message>
    <message>
        <source>values %1 → %2</source>
        <translation>값 %1 → %2</translation>
    </message>
    <message>
        <source>Made a relative job</source>
        <translation>상대 잡으로 변경됨</translation>
    </message>
    <message>
        <source>No longer a relative job</source>
        <translation>더 이상 상대 잡이 아님</translation>
    </message>
    <message>
        <source>The job is locked against editing</source>
        <translation>잡이 편집 금지됨</translation>
    </message>
    <message>
        <source>The job is no longer locked against editing</source>
        <translation>잡의 편집 금지가 해제됨</translation>
    </message>
    <message>
        <source>Made a macro job</source>
        <translation>매크로 잡으로 변경됨</translation>
    </message>
    <message>
        <source>No longer a macro job</source>
        <translation>더 이상 매크로 잡이 아님</translation>
    </message>
    <message>
        <source>Attribute %1 added</source>
        <translation>속성 %1 추가됨</translation>
    </message>
    <message>
        <source>Attribute %1 removed</source>
        <translation>속성 %1 제거됨</translation>
    </message>
    <message>
        <source>Relative frame %1 added</source>
        <translation>상대 좌표 %1 추가됨</translation>
    </message>
    <message>
        <source>Relative frame %1 removed</source>
        <translation>상대 좌표 %1 제거됨</translation>
    </message>
    <message>
        <source>Relative frame: %1 → %2</source>
        <translation>상대 좌표: %1 → %2</translation>
    </message>
    <message>
        <source>Job name: “%1” → “%2”</source>
        <translation>잡 이름: “%1” → “%2”</translation>
    </message>
    <message>
        <source>Job folder: “%1” → “%2”</source>
        <translation>잡 폴더: “%1” → “%2”</translation>
    </message>
    <message>
        <source>Comment of the job: “%1” → “%2”</source>
        <translation>잡의 코멘트: “%1” → “%2”</translation>
    </message>
    <message>
        <source>Control group GROUP%1: %2 → %3</source>
        <translation>제어 그룹 GROUP%1: %2 → %3</translation>
    </message>
    <message>
        <source>Control group GROUP%1 added: %2</source>
        <translation>제어 그룹 GROUP%1 추가됨: %2</translation>
    </message>
    <message>
        <source>Control group GROUP%1 removed: %2</source>
        <translation>제어 그룹 GROUP%1 제거됨: %2</translation>
    </message>
    <message>
        <source>Local variables %1: %2 → %3</source>
        <translation>로컬 변수 %1: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1: %2 → %3</source>
        <translation>%1의 별명: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1 added: %2</source>
        <translation>%1의 별명 추가됨: %2</translation>
    </message>
    <message>
        <source>Alias of %1 removed: %2</source>
        <translation>%1의 별명 제거됨: %2</translation>
    </message>
    <message>
        <source>Argument %1: “%2” → “%3”</source>
        <translation>인수 %1: “%2” → “%3”</translation>
    </message>
    <message>
        <source>Line %1 %2</source>
        <translation>행 %1 %2</translation>
    </message>
    <message>
        <source>Line %1 %2 of %3</source>
        <translation>행 %1 %3의 %2</translation>
    </message>
    <message>
        <source>%1: %2 %3 added</source>
        <translation>%1: %2 %3 추가됨</translation>
    </message>
    <message>
        <source>%1: %2 %3 removed</source>
        <translation>%1: %2 %3 제거됨</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <comment>line and instruction, before, after</comment>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <comment>line and instruction, operand, before, after</comment>
        <translation>%1: %2 %3 → %4</translation>
    </message>
    <message>
        <source>Line %1 added: %2</source>
        <translation>행 %1 추가됨: %2</translation>
    </message>
    <message>
        <source>Line %1 added: %2 (new point: %3)</source>
        <translation>행 %1 추가됨: %2 (새 점: %3)</translation>
    </message>
    <message>
        <source>Line %1 removed: %2</source>
        <translation>행 %1 제거됨: %2</translation>
    </message>
    <message>
        <source>Line %1 removed: %2 (with its point: %3)</source>
        <translation>행 %1 제거됨: %2 (해당 점 포함: %3)</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) moved from line %1 to line %2</source>
        <translation>
            <numerusform>%n개 행이 행 %1에서 행 %2(으)로 이동됨</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 commented out: %2</source>
        <translation>행 %1 코멘트 처리됨: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer commented out: %2</source>
        <translation>행 %1 코멘트 처리 해제됨: %2</translation>
    </message>
    <message>
        <source>Line %1 locked against editing: %2</source>
        <translation>행 %1 편집 금지됨: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer locked against editing: %2</source>
        <translation>행 %1 편집 금지 해제됨: %2</translation>
    </message>
    <message>
        <source>Line %1, comment: “%2” → “%3”</source>
        <translation>행 %1, 코멘트: “%2” → “%3”</translation>
    </message>
    <message>
        <source>Line %1, comment added: “%2”</source>
        <translation>행 %1, 코멘트 추가됨: “%2”</translation>
    </message>
    <message>
        <source>Line %1, comment removed: “%2”</source>
        <translation>행 %1, 코멘트 제거됨: “%2”</translation>
    </message>
    <message>
        <source>Line %1: %2 → %3</source>
        <translation>행 %1: %2 → %3</translation>
    </message>
    <message>
        <source>%1 added: %2</source>
        <comment>a position</comment>
        <translation>%1 추가됨: %2</translation>
    </message>
    <message>
        <source>%1 removed: %2</source>
        <comment>a position</comment>
        <translation>%1 제거됨: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a position</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>journal</name>
    <message>
        <source>%n record(s) of the journal are lost: neither the journal nor %1 could be written.</source>
        <translation>조작 이력의 기록 %n건이 손실되었습니다. 조작 이력에도 %1에도 쓸 수 없었습니다.</translation>
    </message>
    <message>
        <source>%n record(s) could not be written into the journal. Orders and notes are kept in %1.</source>
        <translation>기록 %n건을 조작 이력에 쓸 수 없었습니다. 지령과 메모는 %1에 보관됩니다.</translation>
    </message>
    <message>
        <source>What an earlier program left for the journal cannot be read: %1</source>
        <translation>이전 프로그램이 조작 이력용으로 남긴 내용을 읽을 수 없습니다: %1</translation>
    </message>
</context>
<context>
    <name>journal::Database</name>
    <message>
        <source>The folder of the journal cannot be made.</source>
        <translation>조작 이력 폴더를 만들 수 없습니다.</translation>
    </message>
    <message>
        <source>The journal was made by a newer version of Pendesk.</source>
        <translation>이 조작 이력은 더 새로운 버전의 Pendesk에서 만들어졌습니다.</translation>
    </message>
    <message>
        <source>The damaged journal cannot be given another name.</source>
        <translation>손상된 조작 이력의 이름을 변경할 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>journal::Store</name>
    <message>
        <source>The journal cannot be written: %1. Work goes on; records wait in memory.</source>
        <translation>조작 이력에 쓸 수 없습니다: %1. 작업은 계속되며, 기록은 메모리에 보관됩니다.</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>디스크가 응답하지 않음</translation>
    </message>
</context>
<context>
    <name>models::ActiveAlarmModel</name>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>코드</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>서브 코드</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>내용</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>컨트롤러 시각</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>첫 확인</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>횟수</translation>
    </message>
    <message>
        <source>The controller tells the newest four alarms only, and this is not one of them. It may be active.</source>
        <translation>컨트롤러는 최신 알람 4개만 알려 주며, 이 알람은 여기에 포함되지 않습니다. 발생 중일 수 있습니다.</translation>
    </message>
    <message>
        <source>First seen by this computer: %1</source>
        <translation>이 컴퓨터의 첫 확인: %1</translation>
    </message>
</context>
<context>
    <name>models::AlarmHistoryModel</name>
    <message>
        <source>Controller time</source>
        <translation>컨트롤러 시각</translation>
    </message>
    <message>
        <source>List</source>
        <translation>리스트</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>코드</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>서브 코드</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>내용</translation>
    </message>
    <message>
        <source>Read here</source>
        <translation>읽은 시각</translation>
    </message>
</context>
<context>
    <name>models::CodeStatisticsModel</name>
    <message>
        <source>Code</source>
        <translation>코드</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>횟수</translation>
    </message>
    <message>
        <source>Mean time between</source>
        <translation>평균 간격</translation>
    </message>
    <message>
        <source>Last, controller time</source>
        <translation>마지막, 컨트롤러 시각</translation>
    </message>
    <message>
        <source>%1 d %2 h</source>
        <translation>%1일 %2시간</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1시간 %2분</translation>
    </message>
    <message>
        <source>under a minute</source>
        <translation>1분 미만</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1분</translation>
    </message>
</context>
<context>
    <name>models::FleetModel</name>
    <message>
        <source>ALARM</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>HELD</source>
        <translation>홀드 중</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>홀드: %1</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>운전 중</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>정지</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>에러</translation>
    </message>
    <message>
        <source>NO LINK</source>
        <translation>통신 없음</translation>
    </message>
    <message>
        <source>CHECKING</source>
        <translation>확인 중</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>모드</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>서보</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>왕복 시간</translation>
    </message>
</context>
<context>
    <name>models::IncidentModel</name>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>models::IoModel</name>
    <message>
        <source>refused</source>
        <translation>거부됨</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>models::JobListModel</name>
    <message>
        <source>%1 is being executed.</source>
        <translation>%1이(가) 실행 중입니다.</translation>
    </message>
    <message>
        <source>%1, favourite</source>
        <translation>%1, 즐겨찾기</translation>
    </message>
</context>
<context>
    <name>models::OrderModel</name>
    <message>
        <source>Time</source>
        <translation>시각</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>What</source>
        <translation>내용</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>대상</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>변경</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>응답</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>조작자</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>컴퓨터</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>레벨</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
</context>
<context>
    <name>models::QueueModel</name>
    <message>
        <source>waiting</source>
        <translation>대기 중</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>전송 중</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>취소됨</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>완료</translation>
    </message>
    <message>
        <source>done, read back identical</source>
        <translation>완료, 다시 읽은 내용 일치</translation>
    </message>
    <message numerus="yes">
        <source>done, the controller reformatted %n line(s)</source>
        <translation>
            <numerusform>완료, 컨트롤러가 %n개 행의 서식을 변경함</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ read back different</source>
        <translation>▲ 다시 읽은 내용 불일치</translation>
    </message>
    <message>
        <source>▲ sent, but it could not be read back</source>
        <translation>▲ 송신됨, 다시 읽을 수 없었음</translation>
    </message>
    <message>
        <source>← to the computer</source>
        <translation>← 컴퓨터로</translation>
    </message>
    <message>
        <source>→ to the controller</source>
        <translation>→ 컨트롤러로</translation>
    </message>
    <message>
        <source>✕ delete</source>
        <translation>✕ 삭제</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/초</translation>
    </message>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>바이트</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>남음</translation>
    </message>
</context>
<context>
    <name>models::TrackModel</name>
    <message>
        <source>Not read at that time.</source>
        <translation>그 시각에는 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>플롯</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>신호</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Min in view</source>
        <translation>표시 범위의 최소</translation>
    </message>
    <message>
        <source>Max in view</source>
        <translation>표시 범위의 최대</translation>
    </message>
</context>
<context>
    <name>models::VariableModel</name>
    <message>
        <source>Number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>변경 시각</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>(empty)</source>
        <translation>(비어 있음)</translation>
    </message>
    <message>
        <source>%1 (local)</source>
        <translation>%1 (로컬)</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>읽은 값 %1</translation>
    </message>
    <message>
        <source>→ %1</source>
        <comment>new value</comment>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>wrote %1, reads %2</source>
        <translation>쓴 값 %1, 읽은 값 %2</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <comment>old and new value</comment>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>아직 송신 안 함</translation>
    </message>
    <message>
        <source>not sent: %1</source>
        <translation>송신 안 함: %1</translation>
    </message>
    <message>
        <source>being written…</source>
        <translation>쓰는 중…</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>거부됨: %1</translation>
    </message>
    <message>
        <source>outcome unknown, look at the robot: %1</source>
        <translation>결과를 알 수 없음, 로봇을 확인하십시오: %1</translation>
    </message>
    <message>
        <source>accepted, but another value was read back</source>
        <translation>수락되었으나 다른 값이 읽힘</translation>
    </message>
    <message>
        <source>The controller calls it “%1”.</source>
        <translation>컨트롤러에서의 이름은 “%1”입니다.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>B007, value: 17</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>거부됨</translation>
    </message>
</context>
<context>
    <name>models::WatchModel</name>
    <message>
        <source>Signal</source>
        <translation>신호</translation>
    </message>
    <message>
        <source>In jobs</source>
        <translation>잡에서 사용</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Rising edges</source>
        <translation>상승 에지</translation>
    </message>
    <message>
        <source>Falling edges</source>
        <translation>하강 에지</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>변경 시각</translation>
    </message>
</context>
<context>
    <name>motion::JogStep</name>
    <message>
        <source>A step must be above 0 and at most %1 pulses.</source>
        <translation>스텝은 0보다 크고 %1 펄스 이하이어야 합니다.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1 mm.</source>
        <translation>스텝은 0보다 크고 %1 mm 이하이어야 합니다.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1°.</source>
        <translation>스텝은 0보다 크고 %1° 이하이어야 합니다.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>현재 위치를 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The group has no such axis.</source>
        <translation>이 그룹에 그 축이 없습니다.</translation>
    </message>
</context>
<context>
    <name>motion::Plan</name>
    <message>
        <source>The speed must be above 0 and at most %1 mm/s.</source>
        <translation>속도는 0보다 크고 %1 mm/s 이하이어야 합니다.</translation>
    </message>
    <message>
        <source>The rotation speed must be above 0 and at most %1 °/s.</source>
        <translation>회전 속도는 0보다 크고 %1 °/s 이하이어야 합니다.</translation>
    </message>
    <message>
        <source>The joint speed must be above 0 and at most %1 %.</source>
        <translation>관절 속도는 0보다 크고 %1 % 이하이어야 합니다.</translation>
    </message>
    <message>
        <source>Where this frame stands cannot be read over HSES, so nobody here knows how far the move would go: use the base frame or an increment.</source>
        <translation>이 좌표가 어디에 있는지는 HSES로 읽을 수 없으므로, 여기서는 이동 거리를 알 수 없습니다. 베이스 좌표 또는 증분을 사용하십시오.</translation>
    </message>
    <message>
        <source>This robot stands on base axes, and HSES does not tell where they are in mm: enter where they shall be.</source>
        <translation>이 로봇은 베이스축 위에 있으며, HSES는 베이스축의 위치를 mm로 알려 주지 않습니다. 베이스축의 목표 위치를 입력하십시오.</translation>
    </message>
    <message>
        <source>The position has no six axes.</source>
        <translation>위치에 6축이 없습니다.</translation>
    </message>
    <message>
        <source>The tool point stands outside the box of this controller.</source>
        <translation>제어점이 이 컨트롤러의 허용 범위 밖에 있습니다.</translation>
    </message>
    <message>
        <source>The move would leave the box of this controller.</source>
        <translation>이 이동은 이 컨트롤러의 허용 범위를 벗어납니다.</translation>
    </message>
    <message>
        <source>User and tool frames are off until the profile says that they were checked on the robot.</source>
        <translation>로봇에서 확인했음이 프로파일에 설정될 때까지 유저 좌표와 툴 좌표는 사용할 수 없습니다.</translation>
    </message>
    <message>
        <source>The user frame must be from 1 to 63.</source>
        <translation>유저 좌표는 1부터 63까지이어야 합니다.</translation>
    </message>
    <message>
        <source>The tool must be from 0 to 63.</source>
        <translation>툴은 0부터 63까지이어야 합니다.</translation>
    </message>
    <message>
        <source>A base or a station is moved in pulses.</source>
        <translation>베이스 또는 스테이션은 펄스로 이동합니다.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>현재 위치를 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>A target in pulses can only be reached by a joint move: how far the tool point would go, and so how fast, is not known here.</source>
        <translation>펄스로 지정한 목표에는 관절 동작으로만 도달할 수 있습니다. 제어점의 이동 거리와 속도는 여기서 알 수 없습니다.</translation>
    </message>
    <message>
        <source>This controller has a box, and where pulses lead is not known here: use the base frame.</source>
        <translation>이 컨트롤러에는 허용 범위가 설정되어 있으며, 펄스로 지정한 위치가 어디인지는 여기서 알 수 없습니다. 베이스 좌표를 사용하십시오.</translation>
    </message>
</context>
<context>
    <name>names::Sentences</name>
    <message>
        <source>%1 has no signal #%2.</source>
        <translation>%1에는 신호 #%2이(가) 없습니다.</translation>
    </message>
    <message>
        <source>There is no #%1: the last digit of a signal is 0 to 7.</source>
        <translation>#%1은(는) 없습니다. 신호의 마지막 자리는 0~7입니다.</translation>
    </message>
    <message>
        <source>There is no %1#(%2): this controller has %1#(1) to %1#(%3).</source>
        <translation>%1#(%2)은(는) 없습니다. 이 컨트롤러에는 %1#(1)~%1#(%3)이(가) 있습니다.</translation>
    </message>
    <message>
        <source>“%1” is not a signal. Write #00010, IN#(1) or OT#(1).</source>
        <translation>“%1”은(는) 신호가 아닙니다. #00010, IN#(1) 또는 OT#(1)과 같이 쓰십시오.</translation>
    </message>
</context>
<context>
    <name>pages::ActiveAlarmsCard</name>
    <message>
        <source>Active alarms</source>
        <translation>발생 중인 알람</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>확인</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>모두 확인</translation>
    </message>
    <message>
        <source>Acknowledging is noted on this computer only. The robot does not hear of it.</source>
        <translation>확인은 이 컴퓨터에만 기록됩니다. 로봇에는 전달되지 않습니다.</translation>
    </message>
    <message>
        <source>Choose one or more alarms in the table first.</source>
        <translation>먼저 표에서 알람을 하나 이상 선택하십시오.</translation>
    </message>
    <message>
        <source>Whether there is an alarm is not known now.</source>
        <translation>알람이 있는지 현재 알 수 없습니다.</translation>
    </message>
    <message>
        <source>There is no alarm to clear.</source>
        <translation>해제할 알람이 없습니다.</translation>
    </message>
    <message>
        <source>Clears the alarms whose causes are gone.</source>
        <translation>원인이 없어진 알람을 해제합니다.</translation>
    </message>
    <message>
        <source>Clears, if the cause is gone: %1.</source>
        <translation>원인이 없어졌으면 해제합니다: %1.</translation>
    </message>
    <message>
        <source>Whether there is an error is not known now.</source>
        <translation>에러가 있는지 현재 알 수 없습니다.</translation>
    </message>
    <message>
        <source>Clears the error message at the pendant, and no alarm.</source>
        <translation>펜던트의 에러 메시지를 해제합니다. 알람은 해제하지 않습니다.</translation>
    </message>
    <message>
        <source>There is no error to clear.</source>
        <translation>해제할 에러가 없습니다.</translation>
    </message>
    <message>
        <source>Not connected: nothing is known of the active alarms.</source>
        <translation>연결되어 있지 않음: 발생 중인 알람을 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The alarms have not been read yet.</source>
        <translation>알람을 아직 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The controller does not tell its alarms.</source>
        <translation>컨트롤러가 알람을 알려 주지 않습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active when last seen.</source>
        <translation>
            <numerusform>마지막 확인 시 알람 %n개가 발생 중이었습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>발생 중인 알람이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active, the newest first.</source>
        <translation>
            <numerusform>알람 %n개 발생 중 (최신순).</numerusform>
        </translation>
    </message>
    <message>
        <source>Reset accepted. Reading the alarms…</source>
        <translation>리셋이 수락되었습니다. 알람을 읽고 있습니다…</translation>
    </message>
    <message>
        <source>Reset accepted. Whether an alarm is left is not known: the status cannot be read.</source>
        <translation>리셋이 수락되었습니다. 남은 알람이 있는지 알 수 없습니다. 상태를 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>Reset accepted. No alarm is active any more.</source>
        <translation>리셋이 수락되었습니다. 더 이상 발생 중인 알람이 없습니다.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first.</source>
        <translation>▲ 수락되었으나 아직 발생 중입니다. 먼저 원인을 제거하십시오.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first. Left are: %1.</source>
        <translation>▲ 수락되었으나 아직 발생 중입니다. 먼저 원인을 제거하십시오. 남은 알람: %1.</translation>
    </message>
    <message>
        <source>Cancel error accepted.</source>
        <translation>에러 취소가 수락되었습니다.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmHistoryCard</name>
    <message>
        <source>History</source>
        <translation>이력</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>Past alarms</source>
        <translation>과거 알람</translation>
    </message>
    <message>
        <source>Most frequent</source>
        <translation>발생 빈도순</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>List</source>
        <translation>리스트</translation>
    </message>
    <message>
        <source>All lists</source>
        <translation>모든 리스트</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>검색</translation>
    </message>
    <message>
        <source>Search code, text or time</source>
        <translation>코드, 내용, 시각 검색</translation>
    </message>
    <message>
        <source>Most frequent alarms</source>
        <translation>발생 빈도가 높은 알람</translation>
    </message>
    <message>
        <source>Counted in everything this journal has of the controller. The times between are by the controller&apos;s clock; steps of that clock are left out.</source>
        <translation>이 조작 이력에 있는 이 컨트롤러의 모든 기록으로 집계합니다. 간격은 컨트롤러의 시계 기준이며, 시계가 변경된 구간은 제외합니다.</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>%1의 메모</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>읽기 중지</translation>
    </message>
    <message>
        <source>Read now</source>
        <translation>지금 읽기</translation>
    </message>
    <message numerus="yes">
        <source>Reading the history from the controller: %n entry(s) read.</source>
        <translation>
            <numerusform>컨트롤러에서 이력을 읽고 있습니다. %n건 읽음.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>조작 이력을 읽을 수 없습니다: %1.</translation>
    </message>
    <message numerus="yes">
        <source>Reading was stopped. %n entry(s) in the journal.</source>
        <translation>
            <numerusform>읽기를 중지했습니다. 조작 이력에 %n건.</numerusform>
        </translation>
    </message>
    <message>
        <source>The history could not be read to its end: %1.</source>
        <translation>이력을 끝까지 읽을 수 없었습니다: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n entry(s) of the journal; the export has all of them.</source>
        <translation>
            <numerusform>조작 이력의 최신 %n건. 내보내기에는 모두 포함됩니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) in the journal, kept for ever.</source>
        <translation>
            <numerusform>조작 이력에 %n건, 영구 보관.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export past alarms</source>
        <translation>과거 알람 내보내기</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) exported.</source>
        <translation>
            <numerusform>%n건을 내보냈습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>내보내지 않음: %1.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmNotes</name>
    <message>
        <source>Save note</source>
        <translation>메모 저장</translation>
    </message>
    <message>
        <source>Export notes…</source>
        <translation>메모 내보내기…</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) exported.</source>
        <translation>
            <numerusform>메모 %n개를 내보냈습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>내보내지 않음: %1.</translation>
    </message>
    <message>
        <source>Export notes</source>
        <translation>메모 내보내기</translation>
    </message>
    <message>
        <source>Codes with a note</source>
        <translation>메모가 있는 코드</translation>
    </message>
    <message>
        <source>Alarm code</source>
        <translation>알람 코드</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>원인</translation>
    </message>
    <message>
        <source>What we did</source>
        <translation>조치 내용</translation>
    </message>
    <message>
        <source>The notes cannot be read: %1.</source>
        <translation>메모를 읽을 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>No note yet.</source>
        <translation>아직 메모가 없습니다.</translation>
    </message>
    <message>
        <source>Last changed by %1, %2.</source>
        <translation>마지막 변경: %1, %2.</translation>
    </message>
</context>
<context>
    <name>pages::AxesCard</name>
    <message>
        <source>pulses</source>
        <translation>펄스</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>도</translation>
    </message>
    <message>
        <source>following error, pulses</source>
        <translation>위치 편차, 펄스</translation>
    </message>
    <message>
        <source>torque, raw</source>
        <translation>토크, 원시값</translation>
    </message>
    <message>
        <source>As the controller sends it: the unit is stated nowhere.</source>
        <translation>컨트롤러가 보낸 그대로입니다. 단위는 어디에도 명시되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>encoder, °C</source>
        <translation>엔코더, °C</translation>
    </message>
    <message>
        <source>min</source>
        <translation>최소</translation>
    </message>
    <message>
        <source>max</source>
        <translation>최대</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>축</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C</source>
        <translation>컨버터 %1: %2 °C</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C, last seen %3</source>
        <translation>컨버터 %1: %2 °C, 마지막 확인 %3</translation>
    </message>
    <message>
        <source>Converter temperature: %1</source>
        <translation>컨버터 온도: %1</translation>
    </message>
</context>
<context>
    <name>pages::BackupPage</name>
    <message>
        <source>Backups</source>
        <translation>백업</translation>
    </message>
    <message>
        <source> newest</source>
        <translation> 개 (최신순)</translation>
    </message>
    <message>
        <source>Keep any number</source>
        <translation>개수 제한 없음</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 일</translation>
    </message>
    <message>
        <source>Keep any age</source>
        <translation>기간 제한 없음</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>지금 백업</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>검증</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>고정</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message numerus="yes">
        <source>Good: every byte of %n file(s) is as it was written.</source>
        <translation>
            <numerusform>양호: 파일 %n개의 모든 바이트가 썼을 때와 같습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ Not good: %1</source>
        <translation>▲ 양호하지 않음: %1</translation>
    </message>
    <message>
        <source>After a backup keep</source>
        <translation>백업 후 보관 범위</translation>
    </message>
    <message>
        <source>The last good backup and pinned ones are never deleted.</source>
        <translation>마지막 양호한 백업과 고정된 백업은 삭제하지 않습니다.</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>비교 대상</translation>
    </message>
    <message>
        <source>with the backup before</source>
        <translation>이전 백업과</translation>
    </message>
    <message>
        <source>with the newest backup</source>
        <translation>최신 백업과</translation>
    </message>
    <message>
        <source>with the controller now</source>
        <translation>컨트롤러의 현재 내용과</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>복원…</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>저장 위치: %1</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>고정 해제</translation>
    </message>
    <message>
        <source>Choose a backup first.</source>
        <translation>먼저 백업을 선택하십시오.</translation>
    </message>
    <message>
        <source>Files are being read.</source>
        <translation>파일을 읽고 있습니다.</translation>
    </message>
    <message>
        <source>Reading file %1 of %2…</source>
        <translation>파일 읽는 중 (%1 / %2)…</translation>
    </message>
    <message>
        <source>Reading the lists…</source>
        <translation>목록을 읽고 있습니다…</translation>
    </message>
    <message>
        <source>▲ There is no new backup: %1</source>
        <translation>▲ 새 백업이 없습니다: %1</translation>
    </message>
    <message>
        <source>▲ %1 of %2 files were backed up.</source>
        <translation>▲ 파일 %2개 중 %1개를 백업했습니다.</translation>
    </message>
    <message numerus="yes">
        <source>All %n file(s) were backed up.</source>
        <translation>
            <numerusform>파일 %n개를 모두 백업했습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading every byte…</source>
        <translation>모든 바이트를 읽고 있습니다…</translation>
    </message>
    <message>
        <source>There is no other backup to compare with.</source>
        <translation>비교할 다른 백업이 없습니다.</translation>
    </message>
    <message>
        <source>The controller&apos;s files were read.</source>
        <translation>컨트롤러의 파일을 읽었습니다.</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>폴더…</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>백업 폴더</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>Exported.</source>
        <translation>내보냈습니다.</translation>
    </message>
    <message>
        <source>▲ Not exported: %1</source>
        <translation>▲ 내보내지 못했습니다: %1</translation>
    </message>
    <message>
        <source>Export the backup</source>
        <translation>백업 내보내기</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Zip 파일 (*.zip)</translation>
    </message>
    <message>
        <source>Exporting to %1…</source>
        <translation>%1(으)로 내보내는 중…</translation>
    </message>
    <message>
        <source>the controller now</source>
        <translation>컨트롤러의 현재 내용</translation>
    </message>
</context>
<context>
    <name>pages::CartesianCard</name>
    <message>
        <source>now</source>
        <translation>현재</translation>
    </message>
    <message>
        <source>min</source>
        <translation>최소</translation>
    </message>
    <message>
        <source>max</source>
        <translation>최대</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>제어점</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>형태</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>확장 형태</translation>
    </message>
    <message>
        <source>%1 · base frame, tool %2</source>
        <translation>%1 · 베이스 좌표, 툴 %2</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · 베이스 좌표</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1에는 제어점이 없습니다. HSES는 로봇의 제어점만 알려 줍니다.</translation>
    </message>
    <message>
        <source>%1, base frame, tool %2</source>
        <translation>%1, 베이스 좌표, 툴 %2</translation>
    </message>
</context>
<context>
    <name>pages::ComparisonCard</name>
    <message>
        <source>≠ changed</source>
        <translation>≠ 변경됨</translation>
    </message>
    <message>
        <source>+ new</source>
        <translation>+ 신규</translation>
    </message>
    <message>
        <source>− gone</source>
        <translation>− 없어짐</translation>
    </message>
    <message>
        <source>▲ not read, nobody knows</source>
        <translation>▲ 읽지 않음, 알 수 없음</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>비교 결과</translation>
    </message>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>변경</translation>
    </message>
    <message>
        <source>Files that differ</source>
        <translation>다른 파일</translation>
    </message>
    <message>
        <source>Choose a backup and compare it.</source>
        <translation>백업을 선택하여 비교하십시오.</translation>
    </message>
    <message>
        <source>Not counted as a difference:</source>
        <translation>차이로 계산하지 않는 항목:</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ</source>
        <translation>
            <numerusform>파일 %n개가 다름</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a file above.</source>
        <translation>위에서 파일을 선택하십시오.</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>차이가 없습니다.</translation>
    </message>
    <message>
        <source>This file is not in the backup as it was written.</source>
        <translation>백업에 있는 이 파일은 썼을 때와 다릅니다.</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>집계 제외</translation>
    </message>
    <message>
        <source>Comparison: from %1 to %2</source>
        <translation>비교: %1에서 %2(으)로</translation>
    </message>
    <message>
        <source>The files are being compared…</source>
        <translation>파일을 비교하고 있습니다…</translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %n counter(s), log(s) and the like</source>
        <translation>
            <numerusform>집계 제외: 카운터, 로그 등 %n개</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::CycleCard</name>
    <message>
        <source>Cycle</source>
        <translation>사이클</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>실제</translation>
    </message>
    <message>
        <source>Requested here</source>
        <translation>여기서의 요청</translation>
    </message>
    <message>
        <source>Nothing was requested from here.</source>
        <translation>여기서 요청한 것이 없습니다.</translation>
    </message>
    <message>
        <source>Cycle mode to request</source>
        <translation>요청할 사이클 모드</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>요청</translation>
    </message>
</context>
<context>
    <name>pages::FilePane</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>파일 %n개</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FilesPage</name>
    <message>
        <source>This computer</source>
        <translation>이 컴퓨터</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>다시 읽기</translation>
    </message>
    <message>
        <source>← Fetch</source>
        <translation>← 가져오기</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>편집…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>폴더…</translation>
    </message>
    <message>
        <source>Folder of the files</source>
        <translation>파일 폴더</translation>
    </message>
    <message>
        <source>Type of the files</source>
        <translation>파일 타입</translation>
    </message>
    <message>
        <source>Send →</source>
        <translation>송신 →</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>삭제…</translation>
    </message>
    <message>
        <source>There are no controller files in this folder.</source>
        <translation>이 폴더에 컨트롤러 파일이 없습니다.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>목록을 읽고 있습니다…</translation>
    </message>
    <message>
        <source>The controller lists no files of this type.</source>
        <translation>컨트롤러의 목록에 이 타입의 파일이 없습니다.</translation>
    </message>
    <message>
        <source>Choose files on the left first.</source>
        <translation>먼저 왼쪽에서 파일을 선택하십시오.</translation>
    </message>
    <message>
        <source>Choose files on the right first.</source>
        <translation>먼저 오른쪽에서 파일을 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>pages::FleetPage</name>
    <message>
        <source>View</source>
        <translation>보기</translation>
    </message>
    <message>
        <source>Size of the tiles</source>
        <translation>타일 크기</translation>
    </message>
    <message>
        <source>HOLD ALL</source>
        <translation>전체 HOLD</translation>
    </message>
    <message>
        <source>HOLD all controllers (software)</source>
        <translation>모든 컨트롤러 HOLD (소프트웨어)</translation>
    </message>
    <message>
        <source>every station that is not off</source>
        <translation>OFF가 아닌 모든 컨트롤러</translation>
    </message>
    <message>
        <source>Connect all</source>
        <translation>모두 연결</translation>
    </message>
    <message>
        <source>Back up all</source>
        <translation>모두 백업</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>필터</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>보드</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>표</translation>
    </message>
    <message>
        <source>S</source>
        <translation>소</translation>
    </message>
    <message>
        <source>M</source>
        <translation>중</translation>
    </message>
    <message>
        <source>L</source>
        <translation>대</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>컨트롤러</translation>
    </message>
    <message numerus="yes">
        <source>%n controller(s)</source>
        <translation>
            <numerusform>컨트롤러 %n대</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n대 연결됨</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without link</source>
        <translation>
            <numerusform>%n대 통신 없음</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n station(s) that are not off</source>
        <translation>
            <numerusform>OFF가 아닌 컨트롤러 %n대</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ HOLD was not confirmed by %1: look at the robot.</source>
        <translation>▲ %1에서 HOLD가 확인되지 않았습니다. 로봇을 확인하십시오.</translation>
    </message>
    <message>
        <source>HOLD is being asked of %1.</source>
        <translation>%1에 HOLD를 요청하고 있습니다.</translation>
    </message>
    <message numerus="yes">
        <source>HOLD was confirmed by %n controller(s).</source>
        <translation>
            <numerusform>컨트롤러 %n대에서 HOLD가 확인되었습니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::GroupCard</name>
    <message>
        <source>axis %1</source>
        <translation>축 %1</translation>
    </message>
</context>
<context>
    <name>pages::HoldCard</name>
    <message>
        <source>Hold</source>
        <translation>홀드</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>홀드 원인</translation>
    </message>
</context>
<context>
    <name>pages::IoPage</name>
    <message>
        <source>User in</source>
        <translation>범용 입력</translation>
    </message>
    <message>
        <source>User out</source>
        <translation>범용 출력</translation>
    </message>
    <message>
        <source>External in</source>
        <translation>외부 입력</translation>
    </message>
    <message>
        <source>Network in</source>
        <translation>네트워크 입력</translation>
    </message>
    <message>
        <source>External out</source>
        <translation>외부 출력</translation>
    </message>
    <message>
        <source>Network out</source>
        <translation>네트워크 출력</translation>
    </message>
    <message>
        <source>System in</source>
        <translation>전용 입력</translation>
    </message>
    <message>
        <source>System out</source>
        <translation>전용 출력</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>패널</translation>
    </message>
    <message>
        <source>Relays</source>
        <translation>보조 릴레이</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>제어 상태</translation>
    </message>
    <message>
        <source>Pseudo in</source>
        <translation>의사 입력</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>신호</translation>
    </message>
    <message>
        <source>Area of signals</source>
        <translation>신호 범위</translation>
    </message>
    <message>
        <source>Watched signals</source>
        <translation>워치 중인 신호</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>0부터 다시 세기</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>워치</translation>
    </message>
    <message>
        <source>Over HSES only network inputs can be written: this lamp only shows.</source>
        <translation>HSES로는 네트워크 입력에만 쓸 수 있습니다. 이 램프는 표시 전용입니다.</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>쓰기…</translation>
    </message>
    <message>
        <source>Name it here…</source>
        <translation>여기서 이름 지정…</translation>
    </message>
    <message>
        <source>Take the local name away</source>
        <translation>로컬 이름 제거</translation>
    </message>
    <message>
        <source>Watch no longer</source>
        <translation>워치 중지</translation>
    </message>
    <message>
        <source>Copy the address</source>
        <translation>주소 복사</translation>
    </message>
    <message>
        <source>Edges are counted from what is read four times a second; shorter pulses are not seen.</source>
        <translation>에지는 초당 4회 읽은 값으로 셉니다. 더 짧은 펄스는 확인되지 않습니다.</translation>
    </message>
    <message>
        <source>Network inputs can be written: press Enter on a lamp.</source>
        <translation>네트워크 입력에 쓸 수 있습니다. 램프에서 Enter를 누르십시오.</translation>
    </message>
    <message>
        <source>These lamps only show: over HSES only network inputs can be written.</source>
        <translation>이 램프들은 표시 전용입니다. HSES로는 네트워크 입력에만 쓸 수 있습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) from %1 on are refused: %2.</source>
        <translation>
            <numerusform>%1부터 %n개 그룹이 거부되었습니다: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>The controller&apos;s names are not known: %1.</source>
        <translation>컨트롤러의 이름을 알 수 없습니다: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) of IONAME.DAT could not be read.</source>
        <translation>
            <numerusform>IONAME.DAT의 %n개 행을 읽을 수 없었습니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::JobCard</name>
    <message>
        <source>master task</source>
        <translation>마스터 태스크</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>행</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>스텝</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>속도 오버라이드</translation>
    </message>
</context>
<context>
    <name>pages::JobListCard</name>
    <message>
        <source>Jobs on the controller</source>
        <translation>컨트롤러의 잡</translation>
    </message>
    <message>
        <source>★ Favourite</source>
        <translation>★ 즐겨찾기</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>다시 읽기</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>필터</translation>
    </message>
    <message>
        <source>Filter jobs by name</source>
        <translation>이름으로 잡 필터링</translation>
    </message>
    <message>
        <source>The list could not be read: %1.</source>
        <translation>목록을 읽을 수 없었습니다: %1.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>목록을 읽고 있습니다…</translation>
    </message>
    <message>
        <source>The list was not read yet.</source>
        <translation>목록을 아직 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>There is no job on the controller.</source>
        <translation>컨트롤러에 잡이 없습니다.</translation>
    </message>
    <message>
        <source>No job has “%1” in its name.</source>
        <translation>이름에 “%1”이(가) 포함된 잡이 없습니다.</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>읽는 중…</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s)</source>
        <translation>
            <numerusform>잡 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, read at %2</source>
        <translation>%1, %2에 읽음</translation>
    </message>
</context>
<context>
    <name>pages::JobTextCard</name>
    <message>
        <source>Job text</source>
        <translation>잡 내용</translation>
    </message>
    <message>
        <source>Choose a job in the list to read it.</source>
        <translation>읽을 잡을 목록에서 선택하십시오.</translation>
    </message>
    <message>
        <source>Follow what is executed</source>
        <translation>실행 위치 따라가기</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>다시 읽기</translation>
    </message>
    <message>
        <source>Labels and calls</source>
        <translation>라벨과 호출</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <comment>line and label</comment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>읽는 중…</translation>
    </message>
    <message>
        <source>read at %1</source>
        <translation>%1에 읽음</translation>
    </message>
    <message>
        <source>The job could not be read: %1.</source>
        <translation>잡을 읽을 수 없었습니다: %1.</translation>
    </message>
    <message>
        <source>Read at %1. The controller was in TEACH or the link was lost since: this copy may be old.</source>
        <translation>%1에 읽음. 그 후 컨트롤러가 TEACH였거나 통신이 끊어졌으므로, 이 내용은 이전 것일 수 있습니다.</translation>
    </message>
    <message>
        <source>Reading the job…</source>
        <translation>잡을 읽고 있습니다…</translation>
    </message>
    <message>
        <source>The job was not read yet.</source>
        <translation>잡을 아직 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>This file holds no instructions that could be shown.</source>
        <translation>이 파일에는 표시할 수 있는 명령이 없습니다.</translation>
    </message>
</context>
<context>
    <name>pages::JobsPage</name>
    <message>
        <source>Orders</source>
        <translation>지령</translation>
    </message>
</context>
<context>
    <name>pages::JogCard</name>
    <message>
        <source>Jog</source>
        <translation>조그</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>스텝</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>Keyboard too: hold Ctrl and Space on the button that has the focus</source>
        <translation>키보드 사용: 포커스가 있는 버튼에서 Ctrl과 Space를 누르고 있기</translation>
    </message>
    <message>
        <source>Hold a button: one bounded step after another</source>
        <translation>버튼을 누르고 있기: 제한된 스텝을 하나씩 차례로 실행</translation>
    </message>
    <message>
        <source>After a lost link</source>
        <translation>통신이 끊어진 경우</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>마지막 스텝</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>베이스</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Axes (pulses)</source>
        <translation>축 (펄스)</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 mm/s · %2 °/s</source>
        <translation>%1 mm/s · %2 °/s</translation>
    </message>
    <message>
        <source>at most one step: %1 pulses</source>
        <translation>최대 1스텝: %1 펄스</translation>
    </message>
    <message>
        <source>at most one step: %1 mm or %2°, in %3 s at most</source>
        <translation>최대 1스텝: %1 mm 또는 %2°, 최장 %3초</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>사용 불가: 프로파일에 0보다 큰 수가 아닌 동작 제한값이 있습니다 (%1).</translation>
    </message>
    <message>
        <source>No answer to the step: whether it was taken is unknown. HOLD was sent. Look at the robot.</source>
        <translation>스텝에 대한 응답이 없습니다. 실행되었는지 알 수 없습니다. HOLD를 송신했습니다. 로봇을 확인하십시오.</translation>
    </message>
    <message>
        <source>Step sent…</source>
        <translation>스텝 송신됨…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>이동 중…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at rest.</source>
        <translation>
            <numerusform>%n스텝, 정지 상태.</numerusform>
        </translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>아직 없습니다.</translation>
    </message>
</context>
<context>
    <name>pages::JournalPage</name>
    <message>
        <source>At any time</source>
        <translation>전체 기간</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>오늘</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>최근 7일</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>최근 30일</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>조작 이력</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>All controllers</source>
        <translation>모든 컨트롤러</translation>
    </message>
    <message>
        <source>What</source>
        <translation>내용</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>전체</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Any outcome</source>
        <translation>모든 결과</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>시각</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>검색</translation>
    </message>
    <message>
        <source>Search in all texts</source>
        <translation>모든 텍스트에서 검색</translation>
    </message>
    <message>
        <source>Reading the journal…</source>
        <translation>조작 이력을 읽고 있습니다…</translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>조작 이력을 읽을 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>Nothing was tried that fits this filter.</source>
        <translation>이 필터에 해당하는 조작이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n record(s). Scroll down for older ones.</source>
        <translation>
            <numerusform>최신 기록 %n건. 이전 기록은 아래로 스크롤하십시오.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>기록 %n건</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a record to read all of it here.</source>
        <translation>전체 내용을 볼 기록을 선택하십시오.</translation>
    </message>
    <message>
        <source>%1: %2 at %3.</source>
        <translation>%1: %2 (%3).</translation>
    </message>
    <message>
        <source>Outcome: %1.</source>
        <translation>결과: %1.</translation>
    </message>
    <message>
        <source>By %1 at %2, level %3.</source>
        <translation>실행자: %1 (%2), 레벨: %3.</translation>
    </message>
    <message>
        <source>Export the journal</source>
        <translation>조작 이력 내보내기</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) exported.</source>
        <translation>
            <numerusform>기록 %n건을 내보냈습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>내보내지 않음: %1.</translation>
    </message>
</context>
<context>
    <name>pages::LinkCard</name>
    <message>
        <source>%1 repeated</source>
        <translation>재송신 %1</translation>
    </message>
    <message>
        <source>%1 unanswered</source>
        <translation>무응답 %1</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>지연 %1</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>중복 %1</translation>
    </message>
    <message>
        <source>%1 mismatched</source>
        <translation>불일치 %1</translation>
    </message>
    <message>
        <source>%1 malformed</source>
        <translation>형식 이상 %1</translation>
    </message>
    <message>
        <source>%1 from elsewhere</source>
        <translation>다른 송신원 %1</translation>
    </message>
    <message>
        <source>%1 busy</source>
        <translation>비지 %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>통신</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>최근 60초</translation>
    </message>
    <message>
        <source>round trip p50 / p95</source>
        <translation>왕복 시간 p50 / p95</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>손실</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>요청</translation>
    </message>
    <message>
        <source>last answer</source>
        <translation>마지막 응답</translation>
    </message>
    <message>
        <source>sent / answered</source>
        <translation>송신 / 응답</translation>
    </message>
    <message>
        <source>unusual</source>
        <translation>특이 사항</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 /s of %2</source>
        <translation>%1 /초 (상한 %2)</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1 전</translation>
    </message>
</context>
<context>
    <name>pages::MotionPage</name>
    <message>
        <source>Remote motion in automatic operation. The pendant’s enabling switch does not protect anyone here. Nobody may be inside the fence.</source>
        <translation>자동 운전 중의 원격 동작입니다. 여기서는 펜던트의 인에이블 스위치가 아무도 보호하지 않습니다. 안전 펜스 안에 아무도 있어서는 안 됩니다.</translation>
    </message>
    <message>
        <source>Before each step</source>
        <translation>각 스텝 전</translation>
    </message>
    <message>
        <source>Control group that moves</source>
        <translation>움직일 제어 그룹</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>제어 그룹</translation>
    </message>
</context>
<context>
    <name>pages::MoveCard</name>
    <message>
        <source>Move</source>
        <translation>이동</translation>
    </message>
    <message>
        <source>Type of the move</source>
        <translation>이동 종류</translation>
    </message>
    <message>
        <source>Frame of the target</source>
        <translation>목표 좌표</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>툴</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>유저 좌표</translation>
    </message>
    <message>
        <source>Base axes in mm</source>
        <translation>베이스축 (mm)</translation>
    </message>
    <message>
        <source>Rehearse…</source>
        <translation>사전 확인…</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>관절 동작</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>직선 동작</translation>
    </message>
    <message>
        <source>Straight, increment</source>
        <translation>직선 동작, 증분</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>베이스 좌표</translation>
    </message>
    <message>
        <source>Robot frame</source>
        <translation>로봇 좌표</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>툴 좌표</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>펄스</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>타입</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>now</source>
        <translation>현재</translation>
    </message>
    <message>
        <source>target</source>
        <translation>목표</translation>
    </message>
    <message>
        <source>change</source>
        <translation>변화량</translation>
    </message>
    <message>
        <source>Speed in mm/s</source>
        <translation>속도 (mm/s)</translation>
    </message>
    <message>
        <source>Rotation speed in °/s</source>
        <translation>회전 속도 (°/s)</translation>
    </message>
    <message>
        <source>Joint speed in %</source>
        <translation>관절 속도 (%)</translation>
    </message>
    <message>
        <source>mm/s, at most %1</source>
        <translation>mm/s, 최대 %1</translation>
    </message>
    <message>
        <source>°/s, at most %1</source>
        <translation>°/s, 최대 %1</translation>
    </message>
    <message>
        <source>% of joint speed, at most %1</source>
        <translation>관절 속도의 %, 최대 %1</translation>
    </message>
    <message>
        <source>Target of %1 in %2</source>
        <translation>%1의 목표 (%2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There are three base axes at most.</source>
        <translation>베이스축은 최대 3축입니다.</translation>
    </message>
    <message>
        <source>Base axes: %1</source>
        <translation>베이스축: %1</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>사용 불가: 프로파일에 0보다 큰 수가 아닌 동작 제한값이 있습니다 (%1).</translation>
    </message>
    <message>
        <source>Form: %1</source>
        <translation>형태: %1</translation>
    </message>
</context>
<context>
    <name>pages::Offers</name>
    <message>
        <source>Before sending</source>
        <translation>송신 전</translation>
    </message>
    <message numerus="yes">
        <source>Send %n file(s)</source>
        <translation>
            <numerusform>파일 %n개 송신</numerusform>
        </translation>
    </message>
    <message>
        <source>on this computer</source>
        <translation>이 컴퓨터 측</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>%1 측</translation>
    </message>
    <message>
        <source>What would change in “%1”</source>
        <translation>“%1”에서 바뀔 내용</translation>
    </message>
</context>
<context>
    <name>pages::OptionsCard</name>
    <message>
        <source>always: the button above, the Pause key or Ctrl+Shift+H.</source>
        <translation>언제나: 위의 버튼, Pause 키 또는 Ctrl+Shift+H.</translation>
    </message>
    <message>
        <source>sent repeatedly until confirmed or 2 s have passed. Have the pendant at hand.</source>
        <translation>확인되거나 2초가 지날 때까지 반복 송신합니다. 펜던트를 가까이 두십시오.</translation>
    </message>
    <message>
        <source>there is no connection: use the pendant.</source>
        <translation>연결되어 있지 않습니다. 펜던트를 사용하십시오.</translation>
    </message>
    <message>
        <source>What can I do now?</source>
        <translation>지금 할 수 있는 것은?</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>possible</source>
        <translation>가능</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>불가</translation>
    </message>
</context>
<context>
    <name>pages::PendantCard</name>
    <message>
        <source>Pendant</source>
        <translation>펜던트</translation>
    </message>
    <message>
        <source>Message for the pendant</source>
        <translation>펜던트에 보낼 메시지</translation>
    </message>
    <message>
        <source>Show on the pendant</source>
        <translation>펜던트에 표시</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n byte(s)</source>
        <translation>
            <numerusform>%1 / %n바이트</numerusform>
        </translation>
    </message>
    <message>
        <source>Type a message first.</source>
        <translation>먼저 메시지를 입력하십시오.</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding cannot hold this: %1.</source>
        <translation>컨트롤러의 문자 코드로 나타낼 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>The message is too long for the pendant.</source>
        <translation>메시지가 펜던트에 표시하기에는 너무 깁니다.</translation>
    </message>
    <message>
        <source>HLOCK was switched on from here: the pendant is locked out, but for its emergency stop.</source>
        <translation>여기서 HLOCK을 ON으로 했습니다. 펜던트는 비상 정지를 제외하고 조작할 수 없습니다.</translation>
    </message>
    <message>
        <source>HLOCK locks the pendant out. Whether it is on cannot be read over HSES; from here it was not switched on.</source>
        <translation>HLOCK은 펜던트 조작을 금지합니다. ON인지는 HSES로 읽을 수 없습니다. 여기서는 ON으로 하지 않았습니다.</translation>
    </message>
</context>
<context>
    <name>pages::PointsBar</name>
    <message>
        <source>Take the present position</source>
        <translation>현재 위치 가져오기</translation>
    </message>
    <message>
        <source>Take P</source>
        <translation>P 가져오기</translation>
    </message>
    <message>
        <source>Earlier places</source>
        <translation>이전 위치</translation>
    </message>
    <message>
        <source>Keep the present position as P</source>
        <translation>현재 위치를 P로 저장</translation>
    </message>
    <message>
        <source>P variable</source>
        <translation>P 변수</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>%1 읽는 중…</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>%1을(를) 읽을 수 없었습니다: %2.</translation>
    </message>
    <message>
        <source>%1 is in another frame (%2): choose that frame and an absolute move to take it.</source>
        <translation>%1은(는) 다른 좌표(%2)입니다. 가져오려면 그 좌표와 절대 이동을 선택하십시오.</translation>
    </message>
    <message>
        <source>The target is %1.</source>
        <translation>목표는 %1입니다.</translation>
    </message>
    <message>
        <source>Only the present position of a robot can be kept, once it was read.</source>
        <translation>로봇의 현재 위치만, 읽은 후에 저장할 수 있습니다.</translation>
    </message>
    <message>
        <source>%1 was written and read back.</source>
        <translation>%1을(를) 쓰고 다시 읽어 확인했습니다.</translation>
    </message>
    <message>
        <source>%1 was not verified: %2.</source>
        <translation>%1은(는) 대조되지 않았습니다: %2.</translation>
    </message>
    <message>
        <source>%1 was written, but another value was read back.</source>
        <translation>%1을(를) 썼으나 다른 값이 읽혔습니다.</translation>
    </message>
    <message>
        <source>No move has begun in this frame yet</source>
        <translation>이 좌표에서 시작된 이동이 아직 없습니다</translation>
    </message>
    <message>
        <source>%1 is not taught.</source>
        <translation>%1은(는) 티칭되지 않았습니다.</translation>
    </message>
    <message>
        <source>Other values are still being written.</source>
        <translation>다른 값을 아직 쓰고 있습니다.</translation>
    </message>
    <message>
        <source>%1 holds this position already.</source>
        <translation>%1에는 이미 이 위치가 있습니다.</translation>
    </message>
</context>
<context>
    <name>pages::PositionCard</name>
    <message>
        <source>Position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>R1 · base frame, tool %1  ·  pulses</source>
        <translation>R1 · 베이스 좌표, 툴 %1  ·  펄스</translation>
    </message>
    <message>
        <source>R1 · base frame  ·  pulses</source>
        <translation>R1 · 베이스 좌표  ·  펄스</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>축 %1</translation>
    </message>
</context>
<context>
    <name>pages::PositionPage</name>
    <message>
        <source>Control groups</source>
        <translation>제어 그룹</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>최소와 최대 리셋</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>텍스트로 복사</translation>
    </message>
    <message>
        <source>Not shown because refused: %1 of %2 control groups.</source>
        <translation>거부되어 표시하지 않음: 제어 그룹 %2개 중 %1개.</translation>
    </message>
    <message numerus="yes">
        <source>%n control group(s)</source>
        <translation>
            <numerusform>제어 그룹 %n개</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::QueueCard</name>
    <message>
        <source>Transfers</source>
        <translation>전송</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>실패 항목 재시도</translation>
    </message>
    <message>
        <source>Clear finished</source>
        <translation>완료 항목 지우기</translation>
    </message>
</context>
<context>
    <name>pages::RegistersPage</name>
    <message>
        <source>How registers are written</source>
        <translation>레지스터 표기</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>10진</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>부호 있음</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>16진</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>2진</translation>
    </message>
    <message>
        <source>M000 to M559 can be written; the others belong to the ladder.</source>
        <translation>M000부터 M559까지 쓸 수 있습니다. 나머지는 래더가 사용합니다.</translation>
    </message>
</context>
<context>
    <name>pages::RemoteChanges</name>
    <message>
        <source>What changes in “%1” on %2</source>
        <translation>%2의 “%1”에서 바뀌는 내용</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>송신</translation>
    </message>
    <message>
        <source>Delete on %1</source>
        <translation>%1의 파일 삭제</translation>
    </message>
    <message>
        <source>These files are deleted on %1:
%2
Before that each is copied to %3.</source>
        <translation>%1에서 다음 파일을 삭제합니다:
%2
그 전에 각 파일을 %3에 복사합니다.</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n file(s)</source>
        <translation>
            <numerusform>파일 %n개 삭제</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::SelectCard</name>
    <message>
        <source>Select</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>Select as</source>
        <translation>선택 방법</translation>
    </message>
    <message>
        <source>to be executed</source>
        <translation>실행할 잡</translation>
    </message>
    <message>
        <source>master job</source>
        <translation>마스터 잡</translation>
    </message>
    <message>
        <source>master job of sub task %1</source>
        <translation>서브 태스크 %1의 마스터 잡</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>시작 행</translation>
    </message>
    <message>
        <source>line </source>
        <translation>행 </translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1 선택</translation>
    </message>
    <message>
        <source>Choose a job in the list first.</source>
        <translation>먼저 목록에서 잡을 선택하십시오.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, 행 %2</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>태스크 %1</translation>
    </message>
</context>
<context>
    <name>pages::SelectionCard</name>
    <message>
        <source>Job</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>Where it is</source>
        <translation>현재 위치</translation>
    </message>
    <message>
        <source>master task</source>
        <translation>마스터 태스크</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>운전</translation>
    </message>
</context>
<context>
    <name>pages::ServoCard</name>
    <message>
        <source>Servo</source>
        <translation>서보</translation>
    </message>
    <message>
        <source>Servo power</source>
        <translation>서보 전원</translation>
    </message>
    <message>
        <source>A job is running: servo off stops it at once.</source>
        <translation>잡이 실행 중입니다. 서보 OFF로 하면 즉시 정지합니다.</translation>
    </message>
    <message>
        <source>Servo on…</source>
        <translation>서보 ON…</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>서보 ON</translation>
    </message>
    <message>
        <source>Switch servo power on at %1?

The robot can move from then on. Nobody may be inside the fence.</source>
        <translation>%1의 서보 전원을 ON으로 하시겠습니까?

이후 로봇이 움직일 수 있습니다. 안전 펜스 안에 아무도 있어서는 안 됩니다.</translation>
    </message>
</context>
<context>
    <name>pages::StartCard</name>
    <message>
        <source>Start</source>
        <translation>기동</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>기동…</translation>
    </message>
</context>
<context>
    <name>pages::StartPanel</name>
    <message>
        <source>Start</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>연결되지 않음</translation>
    </message>
    <message>
        <source>Nothing is read and nothing is shown. Connecting only reads: nothing is written, started or moved by it.</source>
        <translation>아무것도 읽지 않고 아무것도 표시하지 않습니다. 연결은 읽기만 하며, 연결로 인해 쓰기, 기동, 이동이 수행되지 않습니다.</translation>
    </message>
    <message>
        <source>Connect to a controller…</source>
        <translation>컨트롤러에 연결…</translation>
    </message>
    <message>
        <source>A controller in your network</source>
        <translation>네트워크의 컨트롤러</translation>
    </message>
    <message>
        <source>Enter its name or address. Pendesk checks step by step whether it answers, and says what is wrong where it does not.</source>
        <translation>이름 또는 주소를 입력하십시오. Pendesk는 컨트롤러가 응답하는지 단계별로 확인하고, 응답하지 않으면 무엇이 잘못되었는지 알려 줍니다.</translation>
    </message>
    <message>
        <source>No robot at hand</source>
        <translation>가까이에 로봇이 없는 경우</translation>
    </message>
    <message>
        <source>The demo brings a simulated controller in this program. Everything can be tried with it, and no robot moves.</source>
        <translation>데모에서는 이 프로그램 안의 시뮬레이션 컨트롤러를 사용합니다. 모든 것을 시험할 수 있으며 로봇은 움직이지 않습니다.</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>데모 열기</translation>
    </message>
    <message>
        <source>Recent controllers</source>
        <translation>최근 컨트롤러</translation>
    </message>
    <message>
        <source>Another controller…</source>
        <translation>다른 컨트롤러…</translation>
    </message>
</context>
<context>
    <name>pages::StateCard</name>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>모드</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>사이클</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>서보</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>운전</translation>
    </message>
    <message>
        <source>Hold · pendant</source>
        <translation>홀드 · 펜던트</translation>
    </message>
    <message>
        <source>Hold · external</source>
        <translation>홀드 · 외부</translation>
    </message>
    <message>
        <source>Hold · command</source>
        <translation>홀드 · 커맨드</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>에러</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>속도 제한</translation>
    </message>
</context>
<context>
    <name>pages::SystemCard</name>
    <message>
        <source>System</source>
        <translation>시스템</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>기종</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>소프트웨어</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>파라미터</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Copy the system information</source>
        <translation>시스템 정보 복사</translation>
    </message>
    <message>
        <source>The profile says %1, but this is the software of a %2: correct the profile.</source>
        <translation>프로파일에는 %1이지만 이 소프트웨어는 %2의 것입니다. 프로파일을 수정하십시오.</translation>
    </message>
</context>
<context>
    <name>pages::TasksCard</name>
    <message>
        <source>Tasks</source>
        <translation>태스크</translation>
    </message>
    <message>
        <source>Show the sub tasks</source>
        <translation>서브 태스크 표시</translation>
    </message>
    <message numerus="yes">
        <source>%n sub task(s)</source>
        <translation>
            <numerusform>서브 태스크 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Sub task %1</source>
        <translation>서브 태스크 %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>pages::TileDelegate</name>
    <message>
        <source>ARMED</source>
        <translation>동작 허가 중</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>시뮬레이션</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>연결 안 됨</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>%1부터</translation>
    </message>
    <message>
        <source>last seen: %1</source>
        <translation>마지막 확인: %1</translation>
    </message>
    <message>
        <source>Servo %1</source>
        <translation>서보 %1</translation>
    </message>
</context>
<context>
    <name>pages::Timeline</name>
    <message>
        <source>▲ no backup any more</source>
        <translation>▲ 더 이상 백업이 아님</translation>
    </message>
    <message numerus="yes">
        <source>▲ %n file(s) missing</source>
        <translation>
            <numerusform>▲ 파일 %n개 없음</numerusform>
        </translation>
    </message>
    <message>
        <source>complete</source>
        <translation>완전함</translation>
    </message>
    <message>
        <source>%1, pinned</source>
        <translation>%1, 고정됨</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>백업 일시</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>백업</translation>
    </message>
    <message>
        <source>Changed</source>
        <comment>number of files</comment>
        <translation>변경</translation>
    </message>
</context>
<context>
    <name>pages::ToolPathCard</name>
    <message>
        <source>Tool path</source>
        <translation>툴 궤적</translation>
    </message>
    <message>
        <source>Clear path</source>
        <translation>궤적 지우기</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · 베이스 좌표</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1에는 제어점이 없습니다. HSES는 로봇의 제어점만 알려 줍니다.</translation>
    </message>
</context>
<context>
    <name>pages::TrendPage</name>
    <message>
        <source>%1 s</source>
        <translation>%1초</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1분</translation>
    </message>
    <message>
        <source>Add signal…</source>
        <translation>신호 추가…</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV 내보내기…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>Freezes the view; recording goes on.</source>
        <translation>표시를 멈춥니다. 기록은 계속됩니다.</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>실시간으로 돌아가기</translation>
    </message>
    <message>
        <source>Time in view</source>
        <translation>표시 시간</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>트렌드</translation>
    </message>
    <message>
        <source>Nothing is plotted yet. Drag a number here from any page, choose “Add to trend” in its menu, or add a signal.</source>
        <translation>아직 플롯이 없습니다. 임의의 페이지에서 숫자를 여기로 끌어 오거나, 그 메뉴에서 “트렌드에 추가”를 선택하거나, 신호를 추가하십시오.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>신호</translation>
    </message>
    <message>
        <source>Remove from trend</source>
        <translation>트렌드에서 제거</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>인시던트</translation>
    </message>
    <message>
        <source>60 s before an alarm, 20 s after</source>
        <translation>알람 60초 전부터 20초 후까지</translation>
    </message>
    <message>
        <source>Open incident</source>
        <translation>인시던트 열기</translation>
    </message>
    <message>
        <source>No alarm has been recorded yet.</source>
        <translation>아직 기록된 알람이 없습니다.</translation>
    </message>
    <message>
        <source>It could not be saved: %1</source>
        <translation>저장할 수 없었습니다: %1</translation>
    </message>
    <message>
        <source>Incident of %1: %2</source>
        <translation>%1의 인시던트: %2</translation>
    </message>
    <message>
        <source>Paused at %1; recording goes on</source>
        <translation>%1에 일시 정지됨. 기록은 계속됩니다</translation>
    </message>
    <message>
        <source>Nothing is recorded: no communication</source>
        <translation>아무것도 기록하지 않음: 통신 없음</translation>
    </message>
    <message>
        <source>Live; values of %1</source>
        <translation>실시간, %1의 값</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>실시간</translation>
    </message>
    <message>
        <source>%1 is refused by the controller.</source>
        <translation>%1은(는) 컨트롤러가 거부했습니다.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>계속</translation>
    </message>
    <message>
        <source>This incident cannot be read: %1</source>
        <translation>이 인시던트를 읽을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>Export what is in view</source>
        <translation>표시 범위 내보내기</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV 파일 (*.csv)</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>파일에 쓸 수 없었습니다: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariableSheet</name>
    <message>
        <source>Discard</source>
        <translation>폐기</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>마지막 쓰기 되돌리기</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>레지스터</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>가져오기…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>%1 can only be read over HSES.</source>
        <translation>%1은(는) HSES로는 읽기만 가능합니다.</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>쓰는 중…</translation>
    </message>
    <message numerus="yes">
        <source>Apply %n…</source>
        <translation>
            <numerusform>%n개 적용…</numerusform>
        </translation>
    </message>
    <message>
        <source>The values are being written.</source>
        <translation>값을 쓰고 있습니다.</translation>
    </message>
    <message>
        <source>Nothing is staged: press Enter in a value.</source>
        <translation>쓰기 예정인 값이 없습니다. 값에서 Enter를 누르십시오.</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>쓰기 예정인 값이 없습니다.</translation>
    </message>
    <message>
        <source>Stages the values that stood there before.</source>
        <translation>쓰기 전의 값을 쓰기 예정에 추가합니다.</translation>
    </message>
    <message>
        <source>Nothing was written that could be undone.</source>
        <translation>되돌릴 수 있는 쓰기가 없습니다.</translation>
    </message>
    <message>
        <source>Import values</source>
        <translation>값 가져오기</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV 파일 (*.csv)</translation>
    </message>
    <message>
        <source>Export values</source>
        <translation>값 내보내기</translation>
    </message>
    <message>
        <source>%1 stays as it is: %2</source>
        <comment>variable: reason</comment>
        <translation>%1은(는) 그대로 유지됩니다: %2</translation>
    </message>
</context>
<context>
    <name>pages::VariableTransfer</name>
    <message>
        <source>%1 was written.</source>
        <translation>%1을(를) 썼습니다.</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n variable(s)…</source>
        <translation>
            <numerusform>변수 %n개를 읽고 있습니다…</numerusform>
        </translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>파일을 읽을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>파일에 쓸 수 없었습니다: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariablesPage</name>
    <message>
        <source>Verify…</source>
        <translation>대조…</translation>
    </message>
    <message>
        <source>Kind of variable</source>
        <translation>변수 종류</translation>
    </message>
    <message>
        <source>Compares two variables with the pendant. It only reads.</source>
        <translation>변수 2개를 펜던트와 비교합니다. 읽기만 합니다.</translation>
    </message>
    <message>
        <source>New watch page…</source>
        <translation>새 워치 페이지…</translation>
    </message>
    <message>
        <source>New watch page</source>
        <translation>새 워치 페이지</translation>
    </message>
    <message>
        <source>Name of the page</source>
        <translation>페이지 이름</translation>
    </message>
    <message>
        <source>Watch: %1</source>
        <translation>워치: %1</translation>
    </message>
    <message>
        <source>Delete this watch page</source>
        <translation>이 워치 페이지 삭제</translation>
    </message>
    <message>
        <source>Show on the watch page “%1”</source>
        <translation>워치 페이지 “%1”에 표시</translation>
    </message>
    <message>
        <source>Take off this watch page</source>
        <translation>이 워치 페이지에서 제거</translation>
    </message>
    <message>
        <source>There is no watch page yet.</source>
        <translation>아직 워치 페이지가 없습니다.</translation>
    </message>
    <message>
        <source>Numbering not verified: nothing is written before it was compared with the pendant.</source>
        <translation>변수 번호 방식이 대조되지 않았습니다. 펜던트와 비교하기 전에는 아무것도 쓰지 않습니다.</translation>
    </message>
    <message>
        <source>Simulation: number %1 on the network is B000.</source>
        <translation>시뮬레이션: 네트워크의 번호 %1이(가) B000입니다.</translation>
    </message>
    <message>
        <source>Numbering verified %1: number %2 on the network is B000.</source>
        <translation>변수 번호 방식 대조됨 (%1): 네트워크의 번호 %2이(가) B000입니다.</translation>
    </message>
</context>
<context>
    <name>pages::start::RecentTile</name>
    <message>
        <source>no connection noted yet</source>
        <translation>아직 연결 기록 없음</translation>
    </message>
    <message>
        <source>connected today %1</source>
        <comment>the time</comment>
        <translation>오늘 %1에 연결됨</translation>
    </message>
    <message>
        <source>connected yesterday %1</source>
        <comment>the time</comment>
        <translation>어제 %1에 연결됨</translation>
    </message>
    <message>
        <source>connected %1 %2</source>
        <comment>the date, the time</comment>
        <translation>%1 %2에 연결됨</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>%1에 연결</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>시뮬레이션</translation>
    </message>
</context>
<context>
    <name>pages::start::SetupCard</name>
    <message>
        <source>What must be set on the pendant</source>
        <translation>펜던트에서 설정해야 하는 것</translation>
    </message>
    <message>
        <source>Menus differ by model and software</source>
        <translation>메뉴는 기종과 소프트웨어에 따라 다릅니다</translation>
    </message>
    <message>
        <source>To be found</source>
        <translation>컨트롤러를 찾으려면</translation>
    </message>
    <message>
        <source>The Ethernet server function (HSES) is on; it is an option of DX100, DX200 and FS100. The controller has an IPv4 address in the network of this computer, and no firewall between them drops UDP %1 and %2.</source>
        <translation>이더넷 서버 기능(HSES)이 ON이어야 합니다. DX100, DX200, FS100에서는 옵션입니다. 컨트롤러에 이 컴퓨터와 같은 네트워크의 IPv4 주소가 있어야 하며, 그 사이의 방화벽이 UDP %1과(와) %2을(를) 차단하지 않아야 합니다.</translation>
    </message>
    <message>
        <source>To take orders</source>
        <translation>지령을 받게 하려면</translation>
    </message>
    <message>
        <source>Only for starting, moving, resetting and files, not for reading: %1.</source>
        <translation>기동, 이동, 리셋, 파일에만 필요하며 읽기에는 필요하지 않습니다: %1.</translation>
    </message>
    <message>
        <source>To select and replace</source>
        <translation>선택하고 바꾸려면</translation>
    </message>
    <message>
        <source>For selecting jobs from here: %1. For replacing files that exist there: %2.</source>
        <translation>여기서 잡을 선택하려면: %1. 컨트롤러에 이미 있는 파일을 바꾸려면: %2.</translation>
    </message>
</context>
<context>
    <name>pendesk</name>
    <message>
        <source>A teach and monitor desk for Yaskawa robot controllers.</source>
        <translation>야스카와 로봇 컨트롤러용 티칭 및 모니터링 데스크입니다.</translation>
    </message>
    <message>
        <source>Connect to a simulated controller inside the program.</source>
        <translation>프로그램 안의 시뮬레이션 컨트롤러에 연결합니다.</translation>
    </message>
    <message>
        <source>light, dark, or auto for the desktop&apos;s choice.</source>
        <translation>light, dark 또는 데스크톱 설정을 따르는 auto.</translation>
    </message>
    <message>
        <source>Language of the window, as a code such as de; the desktop&apos;s unless told otherwise.</source>
        <translation>창의 언어 (de와 같은 코드). 지정하지 않으면 데스크톱의 언어.</translation>
    </message>
    <message>
        <source>Allow watching, HOLD and servo off alone, whatever the person at the desk tries.</source>
        <translation>조작자가 무엇을 시도하든 모니터링, HOLD, 서보 OFF만 허용합니다.</translation>
    </message>
    <message>
        <source>Write pictures of every page to this folder, print the status read, and end.</source>
        <translation>모든 페이지의 그림을 이 폴더에 쓰고, 읽은 상태를 출력한 후 종료합니다.</translation>
    </message>
    <message>
        <source>Print when the window was painted and when the first status was live.</source>
        <translation>창이 그려진 시각과 첫 상태가 실시간이 된 시각을 출력합니다.</translation>
    </message>
    <message>
        <source>--demo brings its own controller: leave out --host and --profile.</source>
        <translation>--demo는 자체 컨트롤러를 사용합니다. --host와 --profile은 지정하지 마십시오.</translation>
    </message>
    <message>
        <source>--theme must be light, dark or auto.</source>
        <translation>--theme은 light, dark, auto 중 하나이어야 합니다.</translation>
    </message>
    <message>
        <source>--language must be one of: %1.</source>
        <translation>--language는 다음 중 하나이어야 합니다: %1.</translation>
    </message>
    <message>
        <source>“%1” is not an option.</source>
        <translation>“%1”은(는) 옵션이 아닙니다.</translation>
    </message>
    <message>
        <source>--pictures needs a folder, and --demo, --host or --profile.</source>
        <translation>--pictures에는 폴더와 --demo, --host, --profile 중 하나가 필요합니다.</translation>
    </message>
    <message>
        <source>Write one picture of all pages, light and dark, in English, German and Japanese, and end.</source>
        <translation>모든 페이지를 밝은 테마와 어두운 테마, 영어·독일어·일본어로 그림 한 장에 쓰고 종료합니다.</translation>
    </message>
    <message>
        <source>--contact-sheet needs a file, and --demo, --host or --profile.</source>
        <translation>--contact-sheet에는 파일과 --demo, --host, --profile 중 하나가 필요합니다.</translation>
    </message>
</context>
<context>
    <name>pendesk::Pictures</name>
    <message>
        <source>not everything was read</source>
        <translation>모두 읽지는 못했습니다</translation>
    </message>
    <message>
        <source>pendesk: %1 cannot be written.</source>
        <translation>pendesk: %1에 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>기종</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>소프트웨어</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>모드</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>사이클</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>서보</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>운전</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>홀드</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>에러</translation>
    </message>
    <message>
        <source>Executing</source>
        <translation>실행 중</translation>
    </message>
    <message>
        <source>Pictures are in %1</source>
        <translation>그림 저장 위치: %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>폴더 %1을(를) 만들 수 없습니다</translation>
    </message>
    <message>
        <source>no live controller within 5 s: %1</source>
        <translation>5초 이내에 실시간 컨트롤러가 없습니다: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1에 쓸 수 없습니다</translation>
    </message>
    <message>
        <source>pendesk: %1.</source>
        <translation>pendesk: %1.</translation>
    </message>
</context>
<context>
    <name>pendeskctl</name>
    <message>
        <source>It stopped at %1. As it was it is in %2; “restore” that one with this name puts it back.</source>
        <translation>%1에서 중지했습니다. 원래 내용은 %2에 있습니다. 이 이름으로 그것을 “restore”하면 되돌아갑니다.</translation>
    </message>
    <message>
        <source>Delete all but the newest N backups afterwards, never the last good one.</source>
        <translation>이후 최신 N개를 제외한 백업을 삭제합니다. 마지막 양호한 백업은 삭제하지 않습니다.</translation>
    </message>
    <message>
        <source>Delete backups older than N days afterwards, never the last good one.</source>
        <translation>이후 N일보다 오래된 백업을 삭제합니다. 마지막 양호한 백업은 삭제하지 않습니다.</translation>
    </message>
    <message>
        <source>Reads all files of the controller into DIR/&lt;controller&gt;/&lt;UTC time&gt;, in BagIt form.</source>
        <translation>컨트롤러의 모든 파일을 BagIt 형식으로 DIR/&lt;controller&gt;/&lt;UTC time&gt;에 읽어 옵니다.</translation>
    </message>
    <message>
        <source>Reads a backup and tells whether it is what was written.</source>
        <translation>백업을 읽고 썼을 때와 같은지 알려 줍니다.</translation>
    </message>
    <message>
        <source>Only print what would be done.</source>
        <translation>실행될 내용만 출력합니다.</translation>
    </message>
    <message>
        <source>The backup is not as it was written; “verify” tells what is wrong. Nothing was done with it.</source>
        <translation>백업이 썼을 때와 다릅니다. 잘못된 내용은 “verify”로 알 수 있습니다. 이 백업으로는 아무것도 하지 않았습니다.</translation>
    </message>
    <message>
        <source>“%1” is no file name.</source>
        <translation>“%1”은(는) 파일 이름이 아닙니다.</translation>
    </message>
    <message>
        <source>Print for people instead of JSON.</source>
        <translation>JSON 대신 사람이 읽는 형식으로 출력합니다.</translation>
    </message>
    <message>
        <source>The request that a reply answers.</source>
        <translation>응답이 대응하는 요청.</translation>
    </message>
    <message>
        <source>The port of the packets: 10040 or 10041.</source>
        <translation>패킷의 포트: 10040 또는 10041.</translation>
    </message>
    <message>
        <source>A packet; without any, one a line on stdin.</source>
        <translation>패킷. 지정하지 않으면 stdin에서 한 행에 하나씩.</translation>
    </message>
    <message>
        <source>A job is running; files are not changed meanwhile.</source>
        <translation>잡이 실행 중입니다. 그동안에는 파일을 변경하지 않습니다.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address.</source>
        <translation>이름 “%1”의 IPv4 주소가 없습니다.</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>폴더 “%1”을(를) 만들 수 없습니다.</translation>
    </message>
    <message>
        <source>%1 exists and is left alone; --yes replaces it.</source>
        <translation>%1이(가) 이미 있으므로 그대로 둡니다. 바꾸려면 --yes를 지정하십시오.</translation>
    </message>
    <message>
        <source>“%1” is no name that a controller takes.</source>
        <translation>“%1”은(는) 컨트롤러가 받는 이름이 아닙니다.</translation>
    </message>
    <message>
        <source>%1 exists at the controller and is left alone; --replace replaces it.</source>
        <translation>%1이(가) 컨트롤러에 이미 있으므로 그대로 둡니다. 바꾸려면 --replace를 지정하십시오.</translation>
    </message>
    <message>
        <source>Lists the jobs.</source>
        <translation>잡 목록을 출력합니다.</translation>
    </message>
    <message>
        <source>The folder for what comes; for rm, for the copies.</source>
        <translation>가져온 파일의 폴더. rm에서는 사본의 폴더.</translation>
    </message>
    <message>
        <source>put: replace what the controller has.</source>
        <translation>put: 컨트롤러에 있는 것을 바꿉니다.</translation>
    </message>
    <message>
        <source>Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”.</source>
        <translation>“ls”, “get NAME…”, “put FILE…”, “rm NAME…” 중 하나를 지정하십시오.</translation>
    </message>
    <message>
        <source>read status, job, position and system information</source>
        <translation>상태, 잡, 위치, 시스템 정보 읽기</translation>
    </message>
    <message>
        <source>read model, system software and parameter version</source>
        <translation>기종, 시스템 소프트웨어, 파라미터 버전 읽기</translation>
    </message>
    <message>
        <source>read the active alarms, or a list of the history</source>
        <translation>발생 중인 알람 또는 이력의 리스트 읽기</translation>
    </message>
    <message>
        <source>read where the robot stands</source>
        <translation>로봇의 현재 위치 읽기</translation>
    </message>
    <message>
        <source>list the jobs</source>
        <translation>잡 목록 출력</translation>
    </message>
    <message>
        <source>read I/O, write a network input</source>
        <translation>I/O 읽기, 네트워크 입력 쓰기</translation>
    </message>
    <message>
        <source>read and write registers</source>
        <translation>레지스터 읽기와 쓰기</translation>
    </message>
    <message>
        <source>read and write variables</source>
        <translation>변수 읽기와 쓰기</translation>
    </message>
    <message>
        <source>list, read, send and delete files</source>
        <translation>파일의 목록 출력, 읽기, 송신, 삭제</translation>
    </message>
    <message>
        <source>read all files of a controller into a new backup</source>
        <translation>컨트롤러의 모든 파일을 새 백업으로 읽기</translation>
    </message>
    <message>
        <source>tell whether a backup is what was written</source>
        <translation>백업이 썼을 때와 같은지 확인</translation>
    </message>
    <message>
        <source>compare two backups, or one with the controller</source>
        <translation>백업 2개 또는 백업과 컨트롤러 비교</translation>
    </message>
    <message>
        <source>send back what differs from a backup</source>
        <translation>백업과 다른 것을 다시 송신</translation>
    </message>
    <message>
        <source>read values again and again</source>
        <translation>값을 반복하여 읽기</translation>
    </message>
    <message>
        <source>take packets given in hex apart</source>
        <translation>16진으로 지정한 패킷 분해</translation>
    </message>
    <message>
        <source>Usage: pendeskctl VERB [options]</source>
        <translation>사용법: pendeskctl VERB [options]</translation>
    </message>
    <message>
        <source>pendeskctl VERB --help tells more.</source>
        <translation>자세한 내용은 pendeskctl VERB --help를 참조하십시오.</translation>
    </message>
    <message>
        <source>there is no verb “%1”.</source>
        <translation>“%1”이라는 VERB는 없습니다.</translation>
    </message>
    <message>
        <source>%1: the controller has no such row of I/O groups.</source>
        <translation>%1: 컨트롤러에 그 범위의 I/O 그룹이 없습니다.</translation>
    </message>
    <message>
        <source>Instance of the first variable on this controller, 0 or 1 (parameter RS022).</source>
        <translation>이 컨트롤러의 첫 변수의 인스턴스, 0 또는 1 (파라미터 RS022).</translation>
    </message>
    <message>
        <source>Print JSON.</source>
        <translation>JSON으로 출력합니다.</translation>
    </message>
    <message>
        <source>Yes, write: what changes something does nothing without it.</source>
        <translation>쓰기를 승인합니다. 지정하지 않으면 변경을 수반하는 조작은 아무것도 하지 않습니다.</translation>
    </message>
    <message>
        <source>No progress and no remarks.</source>
        <translation>진행 상황과 설명을 출력하지 않습니다.</translation>
    </message>
    <message>
        <source>--numbering takes 0 or 1.</source>
        <translation>--numbering에는 0 또는 1을 지정하십시오.</translation>
    </message>
    <message>
        <source>Name the controller with --host or --profile.</source>
        <translation>--host 또는 --profile로 컨트롤러를 지정하십시오.</translation>
    </message>
    <message>
        <source>See pendeskctl %1 --help.</source>
        <translation>pendeskctl %1 --help를 참조하십시오.</translation>
    </message>
    <message>
        <source>This changes something at the controller or on this computer. Add --yes to do it.</source>
        <translation>컨트롤러 또는 이 컴퓨터의 내용이 변경됩니다. 실행하려면 --yes를 추가하십시오.</translation>
    </message>
    <message>
        <source>Say what to read.</source>
        <translation>읽을 대상을 지정하십시오.</translation>
    </message>
    <message>
        <source>Positions are not written from the command line.</source>
        <translation>위치는 명령줄에서 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1에 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>Nobody has verified which instance a variable has on this controller. Compare one value with the pendant, then say --numbering 0 or --numbering 1.</source>
        <translation>이 컨트롤러의 변수가 어느 인스턴스인지 아직 대조되지 않았습니다. 값 하나를 펜던트와 비교한 후 --numbering 0 또는 --numbering 1을 지정하십시오.</translation>
    </message>
    <message>
        <source>Another value was read back: %1</source>
        <translation>다른 값이 읽혔습니다: %1</translation>
    </message>
    <message>
        <source>io set takes one signal, such as 27010, and 0 or 1.</source>
        <translation>io set에는 27010과 같은 신호 하나와 0 또는 1을 지정하십시오.</translation>
    </message>
    <message>
        <source>%1 cannot be written: HSES writes network inputs alone.</source>
        <translation>%1에 쓸 수 없습니다. HSES로는 네트워크 입력에만 쓸 수 있습니다.</translation>
    </message>
    <message>
        <source>Say “get NAME…” or “set NAME VALUE”.</source>
        <translation>“get NAME…” 또는 “set NAME VALUE”를 지정하십시오.</translation>
    </message>
    <message>
        <source>Reads model, system software and parameter version.</source>
        <translation>기종, 시스템 소프트웨어, 파라미터 버전을 읽습니다.</translation>
    </message>
    <message>
        <source>In pulses instead of the base frame.</source>
        <translation>베이스 좌표 대신 펄스로 출력합니다.</translation>
    </message>
    <message>
        <source>A list of the history instead: major, minor, user, system or offline.</source>
        <translation>대신 이력의 리스트: major, minor, user, system 또는 offline.</translation>
    </message>
    <message>
        <source>Reads the active alarms, newest first.</source>
        <translation>발생 중인 알람을 최신순으로 읽습니다.</translation>
    </message>
    <message>
        <source>--history takes major, minor, user, system or offline.</source>
        <translation>--history에는 major, minor, user, system, offline 중 하나를 지정하십시오.</translation>
    </message>
    <message>
        <source>Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input.</source>
        <translation>I/O 그룹의 범위 (2701..2710) 또는 신호 (27010, IN#(1))를 읽습니다. 네트워크 입력 하나를 씁니다.</translation>
    </message>
    <message>
        <source>Reads registers; writes one and reads it back.</source>
        <translation>레지스터를 읽습니다. 하나를 쓰고 다시 읽어 확인합니다.</translation>
    </message>
    <message>
        <source>Reads variables B I D R S P BP EX; writes one and reads it back.</source>
        <translation>변수 B I D R S P BP EX를 읽습니다. 하나를 쓰고 다시 읽어 확인합니다.</translation>
    </message>
    <message>
        <source>Time between two readings: 1s, 200ms.</source>
        <translation>읽기 간격: 1s, 200ms.</translation>
    </message>
    <message>
        <source>End after so many readings.</source>
        <translation>이 횟수만큼 읽은 후 종료합니다.</translation>
    </message>
    <message>
        <source>Reads variables, registers (M005) and I/O again and again, one line of JSON with --json.</source>
        <translation>변수, 레지스터 (M005), I/O를 반복하여 읽습니다. --json을 지정하면 1회에 JSON 한 행입니다.</translation>
    </message>
    <message>
        <source>Reads status, executing job, position and system information once.</source>
        <translation>상태, 실행 중인 잡, 위치, 시스템 정보를 한 번 읽습니다.</translation>
    </message>
    <message>
        <source>Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a copy is written here. What exists is replaced by get with --yes, by put with --replace; put and rm need --yes.</source>
        <translation>파일을 나열하고 읽고 보내고 삭제합니다. 보낸 파일은 다시 읽어 확인하며, 파일을 삭제하기 전에 여기에 사본을 씁니다. 이미 있는 파일은 get에서 --yes, put에서 --replace로 바꿉니다. put과 rm에는 --yes가 필요합니다.</translation>
    </message>
    <message>
        <source>The controller lists no file that “%1” matches.</source>
        <translation>컨트롤러 목록에 “%1”과(와) 일치하는 파일이 없습니다.</translation>
    </message>
    <message>
        <source>The controller is named with --host H, or with --profile NAME as Pendesk keeps it.</source>
        <translation>컨트롤러는 --host H 또는 Pendesk에 저장된 --profile NAME으로 지정합니다.</translation>
    </message>
    <message>
        <source>What changes something does nothing without --yes.</source>
        <translation>무언가를 바꾸는 명령은 --yes 없이는 아무것도 하지 않습니다.</translation>
    </message>
    <message>
        <source>Exit codes: 0 done, 1 differences, 2 wrong call, 3 no answer or outcome unknown, 4 refused,
5 local file error, 6 verification failed, 7 done in part.</source>
        <translation>종료 코드: 0 완료, 1 차이 있음, 2 잘못된 호출, 3 응답 없음 또는 결과 알 수 없음, 4 거부됨,
5 로컬 파일 오류, 6 검증 불합격, 7 일부 완료.</translation>
    </message>
    <message>
        <source>Nobody has verified how this controller numbers its variables (parameter RS022), so these may be their neighbours. --numbering 0 or --numbering 1 settles it.</source>
        <translation>이 컨트롤러가 변수에 번호를 매기는 방식(파라미터 RS022)이 확인되지 않았으므로 이웃 변수일 수 있습니다. --numbering 0 또는 --numbering 1로 정합니다.</translation>
    </message>
    <message>
        <source>Print this and end.</source>
        <translation>이 내용을 출력하고 끝냅니다.</translation>
    </message>
    <message>
        <source>Files restored: %1. The fresh backup is %2.</source>
        <translation>복원한 파일: %1. 새 백업은 %2입니다.</translation>
    </message>
    <message>
        <source>The software of the controller is another than that with which the numbering was verified. Verify it again, or say --numbering 0 or --numbering 1.</source>
        <translation>컨트롤러의 소프트웨어가 번호 방식을 확인했을 때와 다릅니다. 다시 확인하거나 --numbering 0 또는 --numbering 1을 지정하십시오.</translation>
    </message>
    <message>
        <source>Also read ALL.PRM, which repeats the other parameter files and takes a real controller 45 s.</source>
        <translation>ALL.PRM도 읽습니다. 다른 파라미터 파일과 내용이 중복되며 실제 컨트롤러에서는 45초가 걸립니다.</translation>
    </message>
    <message>
        <source>The encoding of texts, such as Shift_JIS.</source>
        <translation>텍스트의 문자 코드 (예: Shift_JIS).</translation>
    </message>
    <message>
        <source>Looks at jobs as before they are sent, and prints what is wrong or odd; exit code 1 if a controller would refuse one.</source>
        <translation>송신 전과 같은 방법으로 잡을 검사하고 잘못되거나 이상한 점을 출력합니다. 컨트롤러가 거부할 잡이 있으면 종료 코드는 1입니다.</translation>
    </message>
    <message>
        <source>Say the files or a folder.</source>
        <translation>파일 또는 폴더를 지정하십시오.</translation>
    </message>
    <message>
        <source>“%1” is no encoding.</source>
        <translation>“%1”은(는) 문자 코드가 아닙니다.</translation>
    </message>
    <message>
        <source>Not counted: %1 counters, %2 logs, %3 other files with nothing but dates, hours or check lines.</source>
        <translation>집계 제외: 카운터 %1개, 로그 %2개, 날짜·시간·검사 행만 다른 기타 파일 %3개.</translation>
    </message>
    <message>
        <source>Count dates, counters, logs, blanks and line ends as differences too.</source>
        <translation>날짜, 카운터, 로그, 공백, 행 끝의 차이도 차이로 계산합니다.</translation>
    </message>
    <message>
        <source>Compares two backups or folders of controller files, or one with the controller, in words; exit code 1 if configuration or data differ.</source>
        <translation>백업 또는 컨트롤러 파일의 폴더 2개, 또는 그 하나와 컨트롤러를 비교하여 문장으로 표시합니다. 설정 또는 데이터가 다르면 종료 코드는 1입니다.</translation>
    </message>
    <message>
        <source>The encoding of texts: %1.</source>
        <translation>텍스트의 문자 코드: %1.</translation>
    </message>
    <message>
        <source>The controller model: %1.</source>
        <translation>컨트롤러의 기종: %1.</translation>
    </message>
    <message>
        <source>look at jobs before they are sent</source>
        <translation>송신하기 전에 잡 검사</translation>
    </message>
    <message>
        <source>tell what controller files say</source>
        <translation>컨트롤러 파일의 내용 표시</translation>
    </message>
    <message>
        <source>The encoding of the pendant&apos;s language instead of the stored one: %1.</source>
        <translation>저장된 문자 코드 대신 사용할 펜던트 언어의 문자 코드: %1.</translation>
    </message>
    <message>
        <source>--encoding takes one of %1.</source>
        <translation>--encoding에는 %1 중 하나를 지정하십시오.</translation>
    </message>
    <message>
        <source>--%1 takes a whole number that is not negative.</source>
        <translation>--%1에는 음수가 아닌 정수를 지정하십시오.</translation>
    </message>
    <message>
        <source>%1 does not take “%2”. See pendeskctl %1 --help.</source>
        <translation>%1에는 “%2”을(를) 지정할 수 없습니다. pendeskctl %1 --help를 참조하십시오.</translation>
    </message>
    <message>
        <source>%1 takes %2. See pendeskctl %1 --help.</source>
        <translation>%1에는 %2이(가) 필요합니다. pendeskctl %1 --help를 참조하십시오.</translation>
    </message>
    <message>
        <source>Reads where a control group stands: the first robot, or R2, B1, S1.</source>
        <translation>제어 그룹의 위치를 읽습니다: 첫 번째 로봇 또는 R2, B1, S1.</translation>
    </message>
    <message>
        <source>“%1” is no control group of a %2: say R1, B1 or S1.</source>
        <translation>“%1”은(는) %2의 제어 그룹이 아닙니다. R1, B1 또는 S1을 지정하십시오.</translation>
    </message>
    <message>
        <source>The backup (left) is of another robot than the controller (right). Nothing was sent. Single jobs and names can be sent by their names.</source>
        <translation>백업(왼쪽)은 컨트롤러(오른쪽)와 다른 로봇의 것입니다. 아무것도 송신하지 않았습니다. 개별 잡과 이름은 그 이름을 지정하여 송신할 수 있습니다.</translation>
    </message>
    <message>
        <source>Sends back what differs from a backup of the same robot: first a fresh backup beside it, then file by file, each read back. Tools, frames and areas only by name; parameters, calibration and ladder never; never while a job runs.</source>
        <translation>같은 로봇의 백업과 다른 것을 다시 송신합니다. 먼저 그 옆에 새 백업을 만들고, 그다음 파일을 하나씩 송신하고 다시 읽어 확인합니다. 툴, 좌표, 영역은 이름을 지정한 경우에만 송신하고, 파라미터, 캘리브레이션, 래더는 송신하지 않습니다. 잡 실행 중에는 수행하지 않습니다.</translation>
    </message>
    <message>
        <source>%1 bytes that are not a text.</source>
        <translation>텍스트가 아닌 %1바이트.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>행 %1: %2</translation>
    </message>
    <message>
        <source>The encoding of the pendant.</source>
        <translation>펜던트의 문자 코드.</translation>
    </message>
    <message>
        <source>Tells what controller files say: names, tools, frames, variables, parameters, ladder, logs. Addresses, users and passwords are masked.</source>
        <translation>컨트롤러 파일의 내용을 표시합니다: 이름, 툴, 좌표, 변수, 파라미터, 래더, 로그. 주소, 사용자, 비밀번호는 가려집니다.</translation>
    </message>
    <message>
        <source>Say a backup, a folder or files.</source>
        <translation>백업, 폴더 또는 파일을 지정하십시오.</translation>
    </message>
    <message>
        <source>There is no encoding “%1”.</source>
        <translation>문자 코드 “%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>--every takes a time such as 200ms or 1s.</source>
        <translation>--every에는 200ms나 1s와 같은 시간을 지정하십시오.</translation>
    </message>
    <message>
        <source>Another signal of the group changed meanwhile; nothing was sent.</source>
        <translation>그사이 그룹의 다른 신호가 변경되어 아무것도 송신하지 않았습니다.</translation>
    </message>
    <message>
        <source>not used in these files</source>
        <translation>이 파일들에서 사용되지 않음</translation>
    </message>
    <message>
        <source>a job that is known when the line runs</source>
        <translation>행 실행 시 정해지는 작업</translation>
    </message>
    <message>
        <source>no file has it</source>
        <translation>어느 파일에도 없음</translation>
    </message>
    <message>
        <source>Tells where variables, signals, registers, tools, frames, macros, alarms and jobs are used: in jobs, in the ladder, in files of names.</source>
        <translation>변수, 신호, 레지스터, 툴, 좌표계, 매크로, 알람, 작업이 사용되는 곳을 알려 줍니다: 작업, 래더, 이름 파일.</translation>
    </message>
    <message>
        <source>Say what to look for, such as B012, IN#(5) or a job.</source>
        <translation>B012, IN#(5) 또는 작업처럼 찾을 대상을 지정하십시오.</translation>
    </message>
    <message>
        <source>Tells which job calls, jumps to or starts which, line by line.</source>
        <translation>어느 작업이 어느 작업을 호출, 점프, 시작하는지 행별로 알려 줍니다.</translation>
    </message>
    <message>
        <source>Tells what is worth a look: jobs that nothing names, jobs that are missing, outputs with several writers, variables that are never written, tools that were not entered.</source>
        <translation>살펴볼 점을 알려 줍니다: 참조되지 않는 작업, 없는 작업, 여러 곳에서 쓰는 출력, 쓰이지 않는 변수, 입력되지 않은 툴.</translation>
    </message>
    <message>
        <source>tell where variables, signals and jobs are used</source>
        <translation>변수, 신호, 작업의 사용 위치 표시</translation>
    </message>
    <message>
        <source>tell which job calls which</source>
        <translation>작업 간 호출 관계 표시</translation>
    </message>
    <message>
        <source>tell what in the files is worth a look</source>
        <translation>파일에서 살펴볼 점 표시</translation>
    </message>
</context>
<context>
    <name>pendeskctl::AlarmReader</name>
    <message>
        <source>There are no alarms.</source>
        <translation>알람이 없습니다.</translation>
    </message>
</context>
<context>
    <name>pendeskctl::Gap</name>
    <message>
        <source>Answers again after %1 s.</source>
        <translation>%1초 후 다시 응답함.</translation>
    </message>
</context>
<context>
    <name>protocol</name>
    <message>
        <source>refused with status %1, which is not in the code list</source>
        <translation>스테이터스 %1로 거부되었습니다 (코드 목록에 없음)</translation>
    </message>
    <message>
        <source>%1 refused, with a code that is not in the code list</source>
        <translation>%1이(가) 거부되었습니다 (코드가 코드 목록에 없음)</translation>
    </message>
    <message>
        <source>the controller did not answer; nothing was changed</source>
        <translation>컨트롤러가 응답하지 않았습니다. 아무것도 변경되지 않았습니다</translation>
    </message>
    <message>
        <source>no answer: it may or may not have happened — look at the robot</source>
        <translation>응답이 없습니다. 실행되었을 수도 있고 실행되지 않았을 수도 있습니다 — 로봇을 확인하십시오</translation>
    </message>
    <message>
        <source>the answer does not fit the question</source>
        <translation>응답이 요청과 맞지 않습니다</translation>
    </message>
    <message>
        <source>nothing was sent</source>
        <translation>아무것도 송신하지 않았습니다</translation>
    </message>
    <message>
        <source>this computer&apos;s network refused</source>
        <translation>이 컴퓨터의 네트워크가 거부했습니다</translation>
    </message>
    <message>
        <source>this cannot be sent to a controller</source>
        <translation>이것은 컨트롤러에 송신할 수 없습니다</translation>
    </message>
    <message>
        <source>a file on this computer could not be read or written</source>
        <translation>이 컴퓨터의 파일을 읽거나 쓸 수 없었습니다</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>취소됨</translation>
    </message>
    <message>
        <source>the command is faulty</source>
        <translation>커맨드에 이상이 있습니다</translation>
    </message>
    <message>
        <source>the command has the wrong number of operands</source>
        <translation>커맨드의 오퍼랜드 수가 틀립니다</translation>
    </message>
    <message>
        <source>an operand is out of its range</source>
        <translation>오퍼랜드가 범위를 벗어났습니다</translation>
    </message>
    <message>
        <source>an operand has the wrong length</source>
        <translation>오퍼랜드의 길이가 틀립니다</translation>
    </message>
    <message>
        <source>the device holds too many files</source>
        <translation>디바이스의 파일이 너무 많습니다</translation>
    </message>
    <message>
        <source>delete files that are not needed</source>
        <translation>필요 없는 파일을 삭제하십시오</translation>
    </message>
    <message>
        <source>the robot is running</source>
        <translation>로봇이 동작 중입니다</translation>
    </message>
    <message>
        <source>wait until it has stopped, or hold it</source>
        <translation>정지할 때까지 기다리거나 홀드하십시오</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>펜던트에 의한 홀드 중입니다</translation>
    </message>
    <message>
        <source>release HOLD on the pendant</source>
        <translation>펜던트에서 HOLD를 해제하십시오</translation>
    </message>
    <message>
        <source>held by the playback panel</source>
        <translation>플레이백 패널에 의한 홀드 중입니다</translation>
    </message>
    <message>
        <source>release HOLD on the panel or pendant</source>
        <translation>패널 또는 펜던트에서 HOLD를 해제하십시오</translation>
    </message>
    <message>
        <source>held by an external signal</source>
        <translation>외부 신호에 의한 홀드 중입니다</translation>
    </message>
    <message>
        <source>release the external hold signal</source>
        <translation>외부 홀드 신호를 해제하십시오</translation>
    </message>
    <message>
        <source>held by a command</source>
        <translation>커맨드에 의한 홀드 중입니다</translation>
    </message>
    <message>
        <source>switch HOLD off</source>
        <translation>HOLD를 OFF로 하십시오</translation>
    </message>
    <message>
        <source>an alarm or error is present</source>
        <translation>알람 또는 에러가 발생 중입니다</translation>
    </message>
    <message>
        <source>remove its cause, then reset the alarm</source>
        <translation>원인을 제거한 후 알람을 리셋하십시오</translation>
    </message>
    <message>
        <source>servo power is off</source>
        <translation>서보 전원이 OFF입니다</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>서보를 ON으로 하십시오</translation>
    </message>
    <message>
        <source>the controller is in the wrong mode</source>
        <translation>컨트롤러의 모드가 틀립니다</translation>
    </message>
    <message>
        <source>turn the pendant key to the mode needed, usually PLAY in REMOTE</source>
        <translation>펜던트의 모드 키를 필요한 모드로 하십시오 (보통 REMOTE의 PLAY)</translation>
    </message>
    <message>
        <source>the files are in use by another function</source>
        <translation>다른 기능이 파일을 사용 중입니다</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>잠시 후 다시 시도하십시오</translation>
    </message>
    <message>
        <source>command remote is not enabled</source>
        <translation>커맨드 리모트가 유효하지 않습니다</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and enable command remote</source>
        <translation>펜던트의 모드 키를 REMOTE로 하고 커맨드 리모트를 유효로 하십시오</translation>
    </message>
    <message>
        <source>this data may not be accessed</source>
        <translation>이 데이터에는 액세스할 수 없습니다</translation>
    </message>
    <message>
        <source>check the security mode and the data protection on the pendant</source>
        <translation>펜던트에서 보안 모드와 데이터 보호를 확인하십시오</translation>
    </message>
    <message>
        <source>this data may not be loaded</source>
        <translation>이 데이터는 로드할 수 없습니다</translation>
    </message>
    <message>
        <source>the data is being edited</source>
        <translation>데이터가 편집 중입니다</translation>
    </message>
    <message>
        <source>leave the editor on the pendant</source>
        <translation>펜던트에서 편집을 종료하십시오</translation>
    </message>
    <message>
        <source>a coordinate conversion is in progress</source>
        <translation>좌표 변환 중입니다</translation>
    </message>
    <message>
        <source>try again when it has ended</source>
        <translation>끝난 후 다시 시도하십시오</translation>
    </message>
    <message>
        <source>servo power must be on first</source>
        <translation>먼저 서보 전원이 ON이어야 합니다</translation>
    </message>
    <message>
        <source>the home position must be set or checked</source>
        <translation>원점 위치의 설정 또는 확인이 필요합니다</translation>
    </message>
    <message>
        <source>check the home position on the pendant</source>
        <translation>펜던트에서 원점 위치를 확인하십시오</translation>
    </message>
    <message>
        <source>the position must be checked</source>
        <translation>위치 확인이 필요합니다</translation>
    </message>
    <message>
        <source>confirm the position on the pendant</source>
        <translation>펜던트에서 위치 확인을 하십시오</translation>
    </message>
    <message>
        <source>the present position is not available</source>
        <translation>현재 위치를 얻을 수 없습니다</translation>
    </message>
    <message>
        <source>the panel lock prohibits a change of mode or cycle</source>
        <translation>패널 잠금으로 모드 또는 사이클의 변경이 금지되어 있습니다</translation>
    </message>
    <message>
        <source>release the panel lock</source>
        <translation>패널 잠금을 해제하십시오</translation>
    </message>
    <message>
        <source>the panel lock prohibits a start</source>
        <translation>패널 잠금으로 기동이 금지되어 있습니다</translation>
    </message>
    <message>
        <source>the user frame is not taught</source>
        <translation>유저 좌표가 티칭되지 않았습니다</translation>
    </message>
    <message>
        <source>teach the user frame</source>
        <translation>유저 좌표를 티칭하십시오</translation>
    </message>
    <message>
        <source>the user frame data is damaged</source>
        <translation>유저 좌표의 데이터가 손상되었습니다</translation>
    </message>
    <message>
        <source>teach the user frame again</source>
        <translation>유저 좌표를 다시 티칭하십시오</translation>
    </message>
    <message>
        <source>the control group is wrong</source>
        <translation>제어 그룹이 틀립니다</translation>
    </message>
    <message>
        <source>choose a control group that this controller has</source>
        <translation>이 컨트롤러에 있는 제어 그룹을 선택하십시오</translation>
    </message>
    <message>
        <source>the base axis data is wrong</source>
        <translation>베이스축 데이터에 이상이 있습니다</translation>
    </message>
    <message>
        <source>a relative job may not be converted</source>
        <translation>상대 잡의 변환이 허가되지 않았습니다</translation>
    </message>
    <message>
        <source>permit the conversion on the pendant</source>
        <translation>펜던트에서 변환을 허가하십시오</translation>
    </message>
    <message>
        <source>a parameter prohibits calling the master job</source>
        <translation>파라미터로 마스터 잡의 호출이 금지되어 있습니다</translation>
    </message>
    <message>
        <source>permit the master call on the pendant</source>
        <translation>펜던트에서 마스터 호출을 허가하십시오</translation>
    </message>
    <message>
        <source>the master job may not be called while operating</source>
        <translation>동작 중에는 마스터 잡을 호출할 수 없습니다</translation>
    </message>
    <message>
        <source>wait until the operation has ended</source>
        <translation>동작이 끝날 때까지 기다리십시오</translation>
    </message>
    <message>
        <source>the teach lock prohibits calling the master job</source>
        <translation>티칭 잠금으로 마스터 잡의 호출이 금지되어 있습니다</translation>
    </message>
    <message>
        <source>release the teach lock</source>
        <translation>티칭 잠금을 해제하십시오</translation>
    </message>
    <message>
        <source>robot calibration data is missing</source>
        <translation>로봇 간 캘리브레이션 데이터가 없습니다</translation>
    </message>
    <message>
        <source>calibrate the robots</source>
        <translation>로봇 간 캘리브레이션을 하십시오</translation>
    </message>
    <message>
        <source>servo power cannot be switched on</source>
        <translation>서보 전원을 ON으로 할 수 없습니다</translation>
    </message>
    <message>
        <source>check the safety chain: emergency stop, safeguards, alarms</source>
        <translation>안전 회로를 확인하십시오: 비상 정지, 안전 보호 장치, 알람</translation>
    </message>
    <message>
        <source>the coordinate system cannot be set</source>
        <translation>좌표계를 설정할 수 없습니다</translation>
    </message>
    <message>
        <source>no memory is left for jobs</source>
        <translation>잡용 메모리가 남아 있지 않습니다</translation>
    </message>
    <message>
        <source>delete jobs that are not needed</source>
        <translation>필요 없는 잡을 삭제하십시오</translation>
    </message>
    <message>
        <source>no memory is left for position data</source>
        <translation>위치 데이터용 메모리가 남아 있지 않습니다</translation>
    </message>
    <message>
        <source>editing of this job is prohibited</source>
        <translation>이 잡의 편집이 금지되어 있습니다</translation>
    </message>
    <message>
        <source>remove the edit lock of the job</source>
        <translation>잡의 편집 금지를 해제하십시오</translation>
    </message>
    <message>
        <source>a job of that name exists</source>
        <translation>같은 이름의 잡이 있습니다</translation>
    </message>
    <message>
        <source>delete or rename it, or permit overwriting</source>
        <translation>삭제하거나 이름을 변경하거나 덮어쓰기를 허가하십시오</translation>
    </message>
    <message>
        <source>the job was not found</source>
        <translation>잡을 찾을 수 없습니다</translation>
    </message>
    <message>
        <source>check the job name</source>
        <translation>잡 이름을 확인하십시오</translation>
    </message>
    <message>
        <source>no job is set for execution</source>
        <translation>실행할 잡이 설정되지 않았습니다</translation>
    </message>
    <message>
        <source>select a job first</source>
        <translation>먼저 잡을 선택하십시오</translation>
    </message>
    <message>
        <source>position data is damaged</source>
        <translation>위치 데이터가 손상되었습니다</translation>
    </message>
    <message>
        <source>load the job again from a backup</source>
        <translation>백업에서 잡을 다시 로드하십시오</translation>
    </message>
    <message>
        <source>position data is missing</source>
        <translation>위치 데이터가 없습니다</translation>
    </message>
    <message>
        <source>teach the missing position</source>
        <translation>없는 위치를 티칭하십시오</translation>
    </message>
    <message>
        <source>the position variable has the wrong type</source>
        <translation>위치 변수의 타입이 틀립니다</translation>
    </message>
    <message>
        <source>write the type that the variable is declared with</source>
        <translation>변수의 선언과 같은 타입으로 쓰십시오</translation>
    </message>
    <message>
        <source>END was reached in a job that is not the master</source>
        <translation>마스터가 아닌 잡에서 END에 도달했습니다</translation>
    </message>
    <message>
        <source>instruction data is damaged</source>
        <translation>명령 데이터가 손상되었습니다</translation>
    </message>
    <message>
        <source>the job name has a character that is not allowed</source>
        <translation>잡 이름에 사용할 수 없는 문자가 있습니다</translation>
    </message>
    <message>
        <source>rename the job</source>
        <translation>잡의 이름을 변경하십시오</translation>
    </message>
    <message>
        <source>a label has a character that is not allowed</source>
        <translation>라벨에 사용할 수 없는 문자가 있습니다</translation>
    </message>
    <message>
        <source>rename the label</source>
        <translation>라벨의 이름을 변경하십시오</translation>
    </message>
    <message>
        <source>this system does not have the instruction</source>
        <translation>이 시스템에 그 명령이 없습니다</translation>
    </message>
    <message>
        <source>the job to convert has no steps</source>
        <translation>변환할 잡에 스텝이 없습니다</translation>
    </message>
    <message>
        <source>the job is converted already</source>
        <translation>잡이 이미 변환되었습니다</translation>
    </message>
    <message>
        <source>the user frame must be taught</source>
        <translation>유저 좌표의 티칭이 필요합니다</translation>
    </message>
    <message>
        <source>relative jobs or independent control are not permitted</source>
        <translation>상대 잡 또는 독립 제어가 허가되지 않았습니다</translation>
    </message>
    <message>
        <source>an instruction has a syntax error</source>
        <translation>명령에 구문 에러가 있습니다</translation>
    </message>
    <message>
        <source>correct the instruction</source>
        <translation>명령을 수정하십시오</translation>
    </message>
    <message>
        <source>the position data has an error</source>
        <translation>위치 데이터에 에러가 있습니다</translation>
    </message>
    <message>
        <source>correct the position section</source>
        <translation>위치 데이터 부분을 수정하십시오</translation>
    </message>
    <message>
        <source>NOP or END is missing</source>
        <translation>NOP 또는 END가 없습니다</translation>
    </message>
    <message>
        <source>begin the instructions with NOP and end them with END</source>
        <translation>명령을 NOP로 시작하고 END로 끝내십시오</translation>
    </message>
    <message>
        <source>the format is wrong</source>
        <translation>형식이 틀립니다</translation>
    </message>
    <message>
        <source>the number of data is wrong</source>
        <translation>데이터 수가 틀립니다</translation>
    </message>
    <message>
        <source>correct the counts in the NPOS line</source>
        <translation>NPOS 행의 수를 수정하십시오</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>값이 범위를 벗어났습니다</translation>
    </message>
    <message>
        <source>correct the value</source>
        <translation>값을 수정하십시오</translation>
    </message>
    <message>
        <source>there is a syntax error outside the instructions</source>
        <translation>명령 이외의 부분에 구문 에러가 있습니다</translation>
    </message>
    <message>
        <source>correct the header of the file</source>
        <translation>파일의 헤더를 수정하십시오</translation>
    </message>
    <message>
        <source>a pseudo instruction is wrong</source>
        <translation>의사 명령에 이상이 있습니다</translation>
    </message>
    <message>
        <source>correct the line that starts with slashes</source>
        <translation>슬래시로 시작하는 행을 수정하십시오</translation>
    </message>
    <message>
        <source>a record of a condition file has an error</source>
        <translation>조건 파일의 레코드에 에러가 있습니다</translation>
    </message>
    <message>
        <source>a record of a job has an error</source>
        <translation>잡의 레코드에 에러가 있습니다</translation>
    </message>
    <message>
        <source>the data comes from a different system</source>
        <translation>다른 시스템의 데이터입니다</translation>
    </message>
    <message>
        <source>the welding type does not match</source>
        <translation>용접 타입이 일치하지 않습니다</translation>
    </message>
    <message>
        <source>the robot or station is operating</source>
        <translation>로봇 또는 스테이션이 동작 중입니다</translation>
    </message>
    <message>
        <source>back up when nothing moves</source>
        <translation>아무것도 움직이지 않을 때 백업하십시오</translation>
    </message>
    <message>
        <source>the device has too little memory</source>
        <translation>디바이스의 메모리가 부족합니다</translation>
    </message>
    <message>
        <source>free memory on the device or use a larger one</source>
        <translation>디바이스의 메모리를 비우거나 더 큰 것을 사용하십시오</translation>
    </message>
    <message>
        <source>the device cannot be accessed</source>
        <translation>디바이스에 액세스할 수 없습니다</translation>
    </message>
    <message>
        <source>check that the device is inserted</source>
        <translation>디바이스가 삽입되어 있는지 확인하십시오</translation>
    </message>
    <message>
        <source>a backup was not expected now</source>
        <translation>지금은 백업을 받아들이는 상태가 아닙니다</translation>
    </message>
    <message>
        <source>the image is larger than the RAM area</source>
        <translation>이미지가 RAM 영역보다 큽니다</translation>
    </message>
    <message>
        <source>enlarge the RAM area for backups</source>
        <translation>백업용 RAM 영역을 늘리십시오</translation>
    </message>
    <message>
        <source>no memory was reserved at power-on</source>
        <translation>전원 투입 시 메모리가 확보되지 않았습니다</translation>
    </message>
    <message>
        <source>switch the controller off and on</source>
        <translation>컨트롤러의 전원을 껐다가 다시 켜십시오</translation>
    </message>
    <message>
        <source>the backup file information cannot be accessed</source>
        <translation>백업 파일의 정보에 액세스할 수 없습니다</translation>
    </message>
    <message>
        <source>the old backup could not be removed</source>
        <translation>이전 백업을 제거할 수 없었습니다</translation>
    </message>
    <message>
        <source>the backup could not be renamed</source>
        <translation>백업의 이름을 변경할 수 없었습니다</translation>
    </message>
    <message>
        <source>the drive name is too long</source>
        <translation>드라이브 이름이 너무 깁니다</translation>
    </message>
    <message>
        <source>the device is the wrong one</source>
        <translation>디바이스가 틀립니다</translation>
    </message>
    <message>
        <source>set the automatic backup to the RAM disk</source>
        <translation>자동 백업을 RAM 디스크로 설정하십시오</translation>
    </message>
    <message>
        <source>a system error occurred</source>
        <translation>시스템 에러가 발생했습니다</translation>
    </message>
    <message>
        <source>automatic backup is not available</source>
        <translation>자동 백업을 사용할 수 없습니다</translation>
    </message>
    <message>
        <source>set up automatic backup on the pendant</source>
        <translation>펜던트에서 자동 백업을 설정하십시오</translation>
    </message>
    <message>
        <source>an automatic backup is running</source>
        <translation>자동 백업이 실행 중입니다</translation>
    </message>
    <message>
        <source>the controller does not know this command</source>
        <translation>컨트롤러가 이 커맨드를 지원하지 않습니다</translation>
    </message>
    <message>
        <source>the number does not exist on this controller</source>
        <translation>그 번호는 이 컨트롤러에 없습니다</translation>
    </message>
    <message>
        <source>check the number and the variable numbering</source>
        <translation>번호와 변수 번호 방식을 확인하십시오</translation>
    </message>
    <message>
        <source>the element does not exist on this controller</source>
        <translation>그 요소는 이 컨트롤러에 없습니다</translation>
    </message>
    <message>
        <source>the reply would be too large for the hardware</source>
        <translation>응답이 하드웨어의 한도를 넘습니다</translation>
    </message>
    <message>
        <source>ask for less at once</source>
        <translation>한 번에 요청하는 양을 줄이십시오</translation>
    </message>
    <message>
        <source>the reply would be too large</source>
        <translation>응답이 너무 큽니다</translation>
    </message>
    <message>
        <source>the position variable is not defined</source>
        <translation>위치 변수가 정의되지 않았습니다</translation>
    </message>
    <message>
        <source>teach or write it first</source>
        <translation>먼저 티칭하거나 쓰십시오</translation>
    </message>
    <message>
        <source>this data may not be used</source>
        <translation>이 데이터는 사용할 수 없습니다</translation>
    </message>
    <message>
        <source>the size of the request data is wrong</source>
        <translation>요청 데이터의 크기가 틀립니다</translation>
    </message>
    <message>
        <source>the data is not set</source>
        <translation>데이터가 설정되지 않았습니다</translation>
    </message>
    <message>
        <source>set it first</source>
        <translation>먼저 설정하십시오</translation>
    </message>
    <message>
        <source>the application is not registered</source>
        <translation>애플리케이션이 등록되지 않았습니다</translation>
    </message>
    <message>
        <source>the type is not registered</source>
        <translation>타입이 등록되지 않았습니다</translation>
    </message>
    <message>
        <source>the control group setting is wrong</source>
        <translation>제어 그룹의 설정이 틀립니다</translation>
    </message>
    <message>
        <source>name either robots or stations that this controller has</source>
        <translation>이 컨트롤러에 있는 로봇 또는 스테이션 중 하나를 지정하십시오</translation>
    </message>
    <message>
        <source>the speed setting is wrong</source>
        <translation>속도의 설정이 틀립니다</translation>
    </message>
    <message>
        <source>use percent for joint and mm/s or °/s for straight moves</source>
        <translation>관절 동작에는 퍼센트를, 직선 동작에는 mm/s 또는 °/s를 사용하십시오</translation>
    </message>
    <message>
        <source>no speed is given</source>
        <translation>속도가 지정되지 않았습니다</translation>
    </message>
    <message>
        <source>give a speed above 0</source>
        <translation>0보다 큰 속도를 지정하십시오</translation>
    </message>
    <message>
        <source>the coordinate system setting is wrong</source>
        <translation>좌표계의 설정이 틀립니다</translation>
    </message>
    <message>
        <source>the type or form setting is wrong</source>
        <translation>타입 또는 형태의 설정이 틀립니다</translation>
    </message>
    <message>
        <source>the tool number is wrong</source>
        <translation>툴 번호가 틀립니다</translation>
    </message>
    <message>
        <source>use 0 to 63</source>
        <translation>0부터 63까지를 사용하십시오</translation>
    </message>
    <message>
        <source>the user frame number is wrong</source>
        <translation>유저 좌표 번호가 틀립니다</translation>
    </message>
    <message>
        <source>use 1 to 63 with a user frame, else 0</source>
        <translation>유저 좌표에서는 1부터 63까지, 그 외에는 0을 사용하십시오</translation>
    </message>
    <message>
        <source>internal error of the controller: data area</source>
        <translation>컨트롤러 내부 에러: 데이터 영역</translation>
    </message>
    <message>
        <source>internal error of the controller: reply area exceeded</source>
        <translation>컨트롤러 내부 에러: 응답 영역 초과</translation>
    </message>
    <message>
        <source>internal error of the controller: element size mismatch</source>
        <translation>컨트롤러 내부 에러: 요소 크기 불일치</translation>
    </message>
    <message>
        <source>internal error of the controller: customised function</source>
        <translation>컨트롤러 내부 에러: 커스터마이즈 기능</translation>
    </message>
    <message>
        <source>another error</source>
        <translation>기타 에러</translation>
    </message>
    <message>
        <source>busy with another command</source>
        <translation>다른 커맨드를 처리 중입니다</translation>
    </message>
    <message>
        <source>another access is in progress</source>
        <translation>다른 액세스가 진행 중입니다</translation>
    </message>
    <message>
        <source>the backup parameter setting is wrong</source>
        <translation>백업 파라미터의 설정이 틀립니다</translation>
    </message>
    <message>
        <source>the backup file was not created</source>
        <translation>백업 파일이 만들어지지 않았습니다</translation>
    </message>
    <message>
        <source>check that the controller is in remote mode</source>
        <translation>컨트롤러가 리모트 모드인지 확인하십시오</translation>
    </message>
    <message>
        <source>internal system error of the controller</source>
        <translation>컨트롤러의 내부 시스템 에러</translation>
    </message>
    <message>
        <source>the transfer was dropped: nothing came in time</source>
        <translation>전송이 중단되었습니다. 시간 내에 아무것도 도착하지 않았습니다</translation>
    </message>
    <message>
        <source>start the transfer again</source>
        <translation>전송을 다시 시작하십시오</translation>
    </message>
    <message>
        <source>the file cannot be overwritten</source>
        <translation>파일을 덮어쓸 수 없습니다</translation>
    </message>
    <message>
        <source>permit overwriting, or delete the file first</source>
        <translation>덮어쓰기를 허가하거나 먼저 파일을 삭제하십시오</translation>
    </message>
    <message>
        <source>the file is missing or empty</source>
        <translation>파일이 없거나 비어 있습니다</translation>
    </message>
    <message>
        <source>check the file name</source>
        <translation>파일 이름을 확인하십시오</translation>
    </message>
    <message>
        <source>the path is wrong</source>
        <translation>경로가 틀립니다</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>경로를 확인하십시오</translation>
    </message>
    <message>
        <source>the file is not in the list</source>
        <translation>파일이 목록에 없습니다</translation>
    </message>
    <message>
        <source>the file may not be deleted</source>
        <translation>이 파일은 삭제할 수 없습니다</translation>
    </message>
    <message>
        <source>the directory may not be deleted</source>
        <translation>이 디렉터리는 삭제할 수 없습니다</translation>
    </message>
    <message>
        <source>files cannot be accessed while remote is off</source>
        <translation>리모트가 OFF인 동안에는 파일에 액세스할 수 없습니다</translation>
    </message>
    <message>
        <source>the file was not found</source>
        <translation>파일을 찾을 수 없습니다</translation>
    </message>
    <message>
        <source>the path is too long</source>
        <translation>경로가 너무 깁니다</translation>
    </message>
    <message>
        <source>use a shorter name</source>
        <translation>더 짧은 이름을 사용하십시오</translation>
    </message>
    <message>
        <source>packet without data</source>
        <translation>데이터가 없는 패킷</translation>
    </message>
    <message>
        <source>packet too large</source>
        <translation>패킷이 너무 큼</translation>
    </message>
    <message>
        <source>packet of size 0</source>
        <translation>크기가 0인 패킷</translation>
    </message>
    <message>
        <source>packet with a wrong block number</source>
        <translation>블록 번호가 틀린 패킷</translation>
    </message>
    <message>
        <source>packet with a wrong ACK byte</source>
        <translation>ACK 바이트가 틀린 패킷</translation>
    </message>
    <message>
        <source>packet of a wrong division</source>
        <translation>처리 구분이 틀린 패킷</translation>
    </message>
    <message>
        <source>check that robot and file port are not exchanged</source>
        <translation>로봇 포트와 파일 포트가 바뀌지 않았는지 확인하십시오</translation>
    </message>
    <message>
        <source>packet with a wrong access level</source>
        <translation>액세스 레벨이 틀린 패킷</translation>
    </message>
    <message>
        <source>packet with a wrong header size</source>
        <translation>헤더 크기가 틀린 패킷</translation>
    </message>
    <message>
        <source>packet with a wrong identifier</source>
        <translation>식별자가 틀린 패킷</translation>
    </message>
    <message>
        <source>announced and received packet sizes differ</source>
        <translation>통지된 패킷 크기와 수신된 패킷 크기가 다름</translation>
    </message>
    <message>
        <source>too many requests</source>
        <translation>요청이 너무 많습니다</translation>
    </message>
    <message>
        <source>ask less often, or try again in a moment</source>
        <translation>요청 빈도를 줄이거나 잠시 후 다시 시도하십시오</translation>
    </message>
    <message>
        <source>the mode was changed and the communication dropped</source>
        <translation>모드가 변경되어 통신이 중단되었습니다</translation>
    </message>
    <message>
        <source>start again in the new mode</source>
        <translation>새 모드에서 다시 시작하십시오</translation>
    </message>
</context>
<context>
    <name>robot::Controller</name>
    <message>
        <source>The name %1 is not known to this computer.</source>
        <translation>이 컴퓨터에서 이름 %1을(를) 알 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>robot::Diagnosis</name>
    <message>
        <source>Host name</source>
        <translation>호스트 이름</translation>
    </message>
    <message>
        <source>Way to the host</source>
        <translation>호스트까지의 경로</translation>
    </message>
    <message>
        <source>Robot port</source>
        <translation>로봇 포트</translation>
    </message>
    <message>
        <source>System information</source>
        <translation>시스템 정보</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>파일 포트</translation>
    </message>
    <message>
        <source>Not looked at, because the step before it failed.</source>
        <translation>앞 단계가 불합격이므로 확인하지 않았습니다.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address on this computer.</source>
        <translation>이 컴퓨터에서 이름 “%1”의 IPv4 주소가 없습니다.</translation>
    </message>
    <message>
        <source>Check the spelling, or enter the controller&apos;s IPv4 address as the pendant shows it.</source>
        <translation>철자를 확인하거나 펜던트에 표시되는 컨트롤러의 IPv4 주소를 입력하십시오.</translation>
    </message>
    <message>
        <source>%1 is %2.</source>
        <translation>%1은(는) %2입니다.</translation>
    </message>
    <message>
        <source>This computer cannot send to %1: %2.</source>
        <translation>이 컴퓨터에서 %1(으)로 송신할 수 없습니다: %2.</translation>
    </message>
    <message>
        <source>Check the cable and this computer&apos;s IPv4 address: it must be in the controller&apos;s network.</source>
        <translation>케이블과 이 컴퓨터의 IPv4 주소를 확인하십시오. 컨트롤러와 같은 네트워크이어야 합니다.</translation>
    </message>
    <message>
        <source>This computer can send to %1.</source>
        <translation>이 컴퓨터에서 %1(으)로 송신할 수 있습니다.</translation>
    </message>
    <message>
        <source>Port %1 answers with a status.</source>
        <translation>포트 %1이(가) 상태를 응답합니다.</translation>
    </message>
    <message>
        <source>Port %1 answers but refuses to tell the status: %2</source>
        <translation>포트 %1이(가) 응답하지만 상태 읽기를 거부합니다: %2</translation>
    </message>
    <message>
        <source>Check on the pendant that the network function server is enabled for this computer.</source>
        <translation>펜던트에서 이 컴퓨터에 대해 네트워크 기능 서버가 유효한지 확인하십시오.</translation>
    </message>
    <message>
        <source>Answers come from another address than %1; they are ignored.</source>
        <translation>응답이 %1이(가) 아닌 다른 주소에서 옵니다. 이 응답은 무시합니다.</translation>
    </message>
    <message>
        <source>Look for a second network card or an address translation between this computer and the controller.</source>
        <translation>이 컴퓨터와 컨트롤러 사이에 두 번째 네트워크 카드 또는 주소 변환이 있는지 확인하십시오.</translation>
    </message>
    <message>
        <source>Something answers at port %1, but not with HSES.</source>
        <translation>포트 %1에서 응답이 있으나 HSES가 아닙니다.</translation>
    </message>
    <message>
        <source>Check the address and the port: HSES is UDP %1 on a controller.</source>
        <translation>주소와 포트를 확인하십시오. 컨트롤러의 HSES는 UDP %1입니다.</translation>
    </message>
    <message>
        <source>The host rejects port %1: %2.</source>
        <translation>호스트가 포트 %1을(를) 거부합니다: %2.</translation>
    </message>
    <message>
        <source>The host is there, but no HSES server: enable the Ethernet server function on the controller.</source>
        <translation>호스트는 있으나 HSES 서버가 없습니다. 컨트롤러의 이더넷 서버 기능을 유효로 하십시오.</translation>
    </message>
    <message>
        <source>Port %1 stays silent.</source>
        <translation>포트 %1이(가) 응답하지 않습니다.</translation>
    </message>
    <message>
        <source>Check that the controller is on, that its Ethernet server function is enabled and that no firewall drops UDP %1.</source>
        <translation>컨트롤러의 전원이 켜져 있는지, 이더넷 서버 기능이 유효한지, 방화벽이 UDP %1을(를) 차단하지 않는지 확인하십시오.</translation>
    </message>
    <message>
        <source>The controller runs %1.</source>
        <translation>컨트롤러의 소프트웨어는 %1입니다.</translation>
    </message>
    <message>
        <source>The controller does not tell its system information: %1</source>
        <translation>컨트롤러가 시스템 정보를 알려 주지 않습니다: %1</translation>
    </message>
    <message>
        <source>Pendesk monitors only a controller that says what it is. Ask its maker for the HSES option.</source>
        <translation>Pendesk는 기종을 알려 주는 컨트롤러만 모니터링합니다. HSES 옵션을 제조사에 문의하십시오.</translation>
    </message>
    <message>
        <source>Port %1 stays silent: files are unavailable, monitoring works.</source>
        <translation>포트 %1이(가) 응답하지 않습니다. 파일은 사용할 수 없으나 모니터링은 가능합니다.</translation>
    </message>
    <message>
        <source>Check that no firewall drops UDP %1.</source>
        <translation>방화벽이 UDP %1을(를) 차단하지 않는지 확인하십시오.</translation>
    </message>
    <message>
        <source>Port %1 answers.</source>
        <translation>포트 %1이(가) 응답합니다.</translation>
    </message>
</context>
<context>
    <name>session::FileSession</name>
    <message>
        <source>An empty file cannot be sent over HSES.</source>
        <translation>빈 파일은 HSES로 송신할 수 없습니다.</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1은(는) %2부터 %3까지의 정수이어야 합니다.</translation>
    </message>
    <message>
        <source>The model “%1” is not known.</source>
        <translation>기종 “%1”을(를) 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The text encoding “%1” is not known.</source>
        <translation>문자 코드 “%1”을(를) 알 수 없습니다.</translation>
    </message>
    <message>
        <source>The variable numbering must be 0 or 1.</source>
        <translation>변수 번호 방식은 0 또는 1이어야 합니다.</translation>
    </message>
    <message>
        <source>Pulses per degree must be lists of numbers, one list for each control group.</source>
        <translation>1도당 펄스 수는 숫자의 리스트이어야 하며, 제어 그룹마다 리스트 하나가 필요합니다.</translation>
    </message>
    <message>
        <source>The profile needs a name.</source>
        <translation>프로파일에 이름이 필요합니다.</translation>
    </message>
    <message>
        <source>The profile needs the controller&apos;s host name or IPv4 address.</source>
        <translation>프로파일에 컨트롤러의 호스트 이름 또는 IPv4 주소가 필요합니다.</translation>
    </message>
</context>
<context>
    <name>settings::CommandLine</name>
    <message>
        <source>--%1 must be a whole number from 1 to 65535.</source>
        <translation>--%1은(는) 1부터 65535까지의 정수이어야 합니다.</translation>
    </message>
    <message>
        <source>--timeout takes a time such as 300ms or 1s.</source>
        <translation>--timeout에는 300ms나 1s와 같은 시간을 지정하십시오.</translation>
    </message>
    <message>
        <source>There is no controller stored under the name “%1”.</source>
        <translation>“%1”이라는 이름으로 저장된 컨트롤러가 없습니다.</translation>
    </message>
    <message>
        <source>Connect to the controller with this name or IPv4 address.</source>
        <translation>이 이름 또는 IPv4 주소의 컨트롤러에 연결합니다.</translation>
    </message>
    <message>
        <source>Its port for robot control, 10040 unless told otherwise.</source>
        <translation>로봇 제어용 포트. 지정하지 않으면 10040.</translation>
    </message>
    <message>
        <source>Its port for file control, 10041 unless told otherwise.</source>
        <translation>파일 제어용 포트. 지정하지 않으면 10041.</translation>
    </message>
    <message>
        <source>Connect to the controller that is stored under this name.</source>
        <translation>이 이름으로 저장된 컨트롤러에 연결합니다.</translation>
    </message>
    <message>
        <source>How long to wait for one try of a read: 300ms, 1s.</source>
        <translation>읽기 1회의 대기 시간: 300ms, 1s.</translation>
    </message>
    <message>
        <source>--%1 needs --host or --profile.</source>
        <translation>--%1에는 --host 또는 --profile이 필요합니다.</translation>
    </message>
    <message>
        <source>--model must be dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>--model은 dx100, dx200, fs100, yrc1000 또는 yrc1000micro이어야 합니다.</translation>
    </message>
    <message>
        <source>Its model: dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>컨트롤러의 기종: dx100, dx200, fs100, yrc1000 또는 yrc1000micro.</translation>
    </message>
    <message>
        <source>What to log, as &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</source>
        <translation>기록할 로그 (예: &quot;pendesk.session=true;pendesk.journal.debug=false&quot;).</translation>
    </message>
</context>
<context>
    <name>settings::Profile</name>
    <message>
        <source>Port</source>
        <translation>포트</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>파일 포트</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>읽기 타임아웃</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>파일 타임아웃</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>서보 타임아웃</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>읽기 재시도 횟수</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>동시에 응답을 기다리는 요청 수</translation>
    </message>
    <message>
        <source>Requests a second</source>
        <translation>초당 요청 수</translation>
    </message>
</context>
<context>
    <name>settings::SettingsFile</name>
    <message>
        <source>The last good ones, of %1, are used.</source>
        <translation>%1의 마지막 정상 설정을 사용합니다.</translation>
    </message>
    <message>
        <source>There is no good copy of them.</source>
        <translation>정상적인 사본이 없습니다.</translation>
    </message>
    <message>
        <source>The settings in %1 are gone.</source>
        <translation>%1의 설정이 없어졌습니다.</translation>
    </message>
    <message>
        <source>The settings cannot be read: %1.</source>
        <translation>설정을 읽을 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>The settings are damaged; they are kept as %1.</source>
        <translation>설정이 손상되어 %1(으)로 보관했습니다.</translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation>다른 프로그램이 %1을(를) 사용 중</translation>
    </message>
    <message>
        <source>Settings could not be saved in time and are lost: %1</source>
        <translation>설정을 제때 저장하지 못해 손실되었습니다: %1</translation>
    </message>
    <message>
        <source>Settings cannot be saved: %1. Work goes on; it is tried again.</source>
        <translation>설정을 저장할 수 없습니다: %1. 작업은 계속되며 저장을 다시 시도합니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the earlier settings cannot be read; they stay in %1.</source>
        <translation>
            <numerusform>이전 설정의 항목 %n개를 읽을 수 없습니다. %1에 그대로 남습니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>station::Fleet</name>
    <message>
        <source>%1: %2</source>
        <comment>controller: sentence</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>station::Station</name>
    <message numerus="yes">
        <source>%n staged value(s) were not applied.</source>
        <translation>
            <numerusform>쓰기 예정인 값 %n개가 적용되지 않았습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Files are still being transferred.</source>
        <translation>파일이 아직 전송 중입니다.</translation>
    </message>
    <message>
        <source>Files are still being read or sent for a backup, a comparison or a restore.</source>
        <translation>백업, 비교 또는 복원을 위해 아직 파일을 읽거나 송신하고 있습니다.</translation>
    </message>
</context>
<context>
    <name>trend</name>
    <message>
        <source>Alarm %1 [%2] %3</source>
        <translation>알람 %1 [%2] %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>잡 %1</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation>스텝 모드</translation>
    </message>
    <message>
        <source>One cycle</source>
        <translation>1사이클</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>연속</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>운전 중</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>속도 제한</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>PLAY</translation>
    </message>
    <message>
        <source>REMOTE</source>
        <translation>REMOTE</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>펜던트에 의한 홀드 중</translation>
    </message>
    <message>
        <source>Held externally</source>
        <translation>외부에 의한 홀드 중</translation>
    </message>
    <message>
        <source>Held by command</source>
        <translation>커맨드에 의한 홀드 중</translation>
    </message>
    <message>
        <source>Alarm active</source>
        <translation>알람 발생 중</translation>
    </message>
    <message>
        <source>Error active</source>
        <translation>에러 발생 중</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>서보 ON</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>잡 행</translation>
    </message>
    <message>
        <source>Job step</source>
        <translation>잡 스텝</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>속도 오버라이드</translation>
    </message>
    <message>
        <source>%1, sub task %2</source>
        <translation>%1, 서브 태스크 %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 following error</source>
        <translation>%1 %2 위치 편차</translation>
    </message>
    <message>
        <source>%1 %2 torque</source>
        <translation>%1 %2 토크</translation>
    </message>
    <message>
        <source>%1 %2 encoder temperature</source>
        <translation>%1 %2 엔코더 온도</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>펄스</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>Converter temperature, board %1</source>
        <translation>컨버터 온도, 기판 %1</translation>
    </message>
    <message>
        <source>Running time %1</source>
        <translation>가동 시간 %1</translation>
    </message>
    <message>
        <source>Alarm code %1</source>
        <translation>알람 코드 %1</translation>
    </message>
</context>
<context>
    <name>trend::Recorder</name>
    <message>
        <source>An incident is lost: %1 could not be written in time.</source>
        <translation>인시던트가 손실되었습니다. %1을(를) 제때 쓸 수 없었습니다.</translation>
    </message>
</context>
<context>
    <name>ui::AccessSwitch</name>
    <message>
        <source>Passcode and idle time…</source>
        <translation>패스코드와 무조작 시간…</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>액세스 레벨: %1</translation>
    </message>
    <message>
        <source>This program was started with --monitor-only: it watches and holds.</source>
        <translation>이 프로그램은 --monitor-only로 시작되었습니다. 모니터링과 홀드만 합니다.</translation>
    </message>
    <message numerus="yes">
        <source>What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.</source>
        <translation>
            <numerusform>여기서 할 수 있는 조작의 범위입니다. %n분간 키와 마우스 조작이 없으면 “모니터”로 돌아갑니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Announcer</name>
    <message>
        <source>New alarm %1: %2</source>
        <translation>새 알람 %1: %2</translation>
    </message>
</context>
<context>
    <name>ui::ArmBadge</name>
    <message>
        <source>This controller is armed: press to disarm.</source>
        <translation>이 컨트롤러는 동작 허가 중입니다. 누르면 해제합니다.</translation>
    </message>
    <message>
        <source>ARMED · %1 s</source>
        <translation>동작 허가 중 · %1초</translation>
    </message>
    <message numerus="yes">
        <source>Armed for %n more second(s). Press to disarm.</source>
        <translation>
            <numerusform>동작 허가가 %n초 남았습니다. 누르면 해제합니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::BackupAge</name>
    <message>
        <source>No backup</source>
        <translation>백업 없음</translation>
    </message>
    <message numerus="yes">
        <source>Backup %n hour(s) old</source>
        <translation>
            <numerusform>백업 %n시간 전</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Backup %n day(s) old</source>
        <translation>
            <numerusform>백업 %n일 전</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Old backup: %n day(s)</source>
        <translation>
            <numerusform>오래된 백업: %n일</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ControllerView</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>HLOCK is on at %1: the pendant is locked out, but for its emergency stop.</source>
        <translation>%1의 HLOCK이 ON입니다. 펜던트는 비상 정지를 제외하고 조작할 수 없습니다.</translation>
    </message>
    <message>
        <source>Release HLOCK</source>
        <translation>HLOCK 해제</translation>
    </message>
    <message numerus="yes">
        <source>The journal works again. %n record(s) were lost.</source>
        <translation>
            <numerusform>조작 이력이 다시 동작합니다. 기록 %n건이 손실되었습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal was damaged. It was kept as %1, and a new one was begun.</source>
        <translation>조작 이력이 손상되었습니다. %1(으)로 보관하고 새 조작 이력을 시작했습니다.</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Level: %1</source>
        <translation>레벨: %1</translation>
    </message>
    <message>
        <source>HLOCK is on</source>
        <translation>HLOCK이 ON입니다</translation>
    </message>
    <message>
        <source>Pendesk</source>
        <translation>Pendesk</translation>
    </message>
    <message>
        <source>%1 — Pendesk</source>
        <translation>%1 — Pendesk</translation>
    </message>
    <message>
        <source>The demo could not be started: %1.</source>
        <translation>데모를 시작할 수 없었습니다: %1.</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Pendesk 정보</translation>
    </message>
    <message>
        <source>Pendesk %1

A teach and monitor desk for Yaskawa robot controllers.
Free software under the GNU General Public License, version 3 or later.

HOLD is a software hold over the network, not a safety function.</source>
        <translation>Pendesk %1

야스카와 로봇 컨트롤러용 티칭 및 모니터링 데스크입니다.
GNU General Public License 버전 3 이상에 따른 자유 소프트웨어입니다.

HOLD는 네트워크를 통한 소프트웨어 홀드이며 안전 기능이 아닙니다.</translation>
    </message>
    <message>
        <source>There is no connection.</source>
        <translation>연결되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>The connection is open.</source>
        <translation>연결되어 있습니다.</translation>
    </message>
    <message>
        <source>No controller is chosen.</source>
        <translation>컨트롤러가 선택되지 않았습니다.</translation>
    </message>
    <message>
        <source>No controller is chosen: connect first.</source>
        <translation>컨트롤러가 선택되지 않았습니다. 먼저 연결하십시오.</translation>
    </message>
    <message>
        <source>%1 requests/s</source>
        <translation>%1 요청/초</translation>
    </message>
    <message>
        <source>Something is unfinished</source>
        <translation>완료되지 않은 것이 있습니다</translation>
    </message>
    <message>
        <source>Go on and lose it</source>
        <translation>폐기하고 계속</translation>
    </message>
    <message>
        <source>HLOCK is still on at %1: the pendant stays locked out if you go on.</source>
        <translation>%1의 HLOCK이 아직 ON입니다. 계속하면 펜던트는 조작할 수 없는 상태로 남습니다.</translation>
    </message>
    <message>
        <source>Release HLOCK and go on</source>
        <translation>HLOCK을 해제하고 계속</translation>
    </message>
    <message>
        <source>Go on and leave it on</source>
        <translation>ON인 채로 계속</translation>
    </message>
</context>
<context>
    <name>ui::NavigationRail</name>
    <message>
        <source>CONTROLLERS</source>
        <translation>컨트롤러</translation>
    </message>
    <message>
        <source>PAGES</source>
        <translation>페이지</translation>
    </message>
    <message>
        <source>CONNECTION</source>
        <translation>연결</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>메뉴</translation>
    </message>
</context>
<context>
    <name>ui::RobotStrip</name>
    <message>
        <source>SIMULATION</source>
        <translation>시뮬레이션</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>통신</translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>컨트롤러 없음</translation>
    </message>
    <message>
        <source>Link · %1 ago</source>
        <translation>통신 · %1 전</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>끊김</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>응답 없음</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>확인 중…</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>연결 안 됨</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>모드</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>서보</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>운전</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>홀드</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>알람</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>에러</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>잡</translation>
    </message>
    <message>
        <source>Job · %1</source>
        <translation>잡 · %1</translation>
    </message>
</context>
<context>
    <name>ui::StationList</name>
    <message numerus="yes">
        <source>%n more in Fleet</source>
        <translation>
            <numerusform>플릿에 %n대 더 있음</numerusform>
        </translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>컨트롤러 없음</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>연결 안 됨</translation>
    </message>
</context>
<context>
    <name>values</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>number</source>
        <translation>숫자</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8비트</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>축</translation>
    </message>
    <message>
        <source>conveyor files</source>
        <translation>컨베이어 파일</translation>
    </message>
    <message>
        <source>robots and stations</source>
        <translation>로봇과 스테이션</translation>
    </message>
    <message>
        <source>signed number</source>
        <translation>부호 있는 수</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16비트</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>robots, stations and bases</source>
        <translation>로봇, 스테이션, 베이스</translation>
    </message>
    <message>
        <source>control group, low and high axes</source>
        <translation>제어 그룹, 하위 축과 상위 축</translation>
    </message>
    <message>
        <source>control group, minimum and maximum axes</source>
        <translation>제어 그룹, 축의 최소와 최대</translation>
    </message>
    <message>
        <source>control group, minimum and maximum X Y Z</source>
        <translation>제어 그룹, X Y Z의 최소와 최대</translation>
    </message>
    <message>
        <source>axes of two control groups</source>
        <translation>제어 그룹 2개의 축</translation>
    </message>
    <message>
        <source>two sets of axes of a control group</source>
        <translation>제어 그룹 1개의 축 2조</translation>
    </message>
    <message>
        <source>axes of a control group and a number</source>
        <translation>제어 그룹의 축과 숫자</translation>
    </message>
    <message>
        <source>control group and a number</source>
        <translation>제어 그룹과 숫자</translation>
    </message>
    <message>
        <source>unknown type %1</source>
        <translation>알 수 없는 타입 %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>정면</translation>
    </message>
    <message>
        <source>back</source>
        <translation>후면</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>상방 암</translation>
    </message>
    <message>
        <source>lower arm</source>
        <translation>하방 암</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>플립</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>논플립</translation>
    </message>
    <message>
        <source>R &lt; 180</source>
        <translation>R &lt; 180</translation>
    </message>
    <message>
        <source>R &gt;= 180</source>
        <translation>R &gt;= 180</translation>
    </message>
    <message>
        <source>T &lt; 180</source>
        <translation>T &lt; 180</translation>
    </message>
    <message>
        <source>T &gt;= 180</source>
        <translation>T &gt;= 180</translation>
    </message>
    <message>
        <source>S &lt; 180</source>
        <translation>S &lt; 180</translation>
    </message>
    <message>
        <source>S &gt;= 180</source>
        <translation>S &gt;= 180</translation>
    </message>
    <message>
        <source>redundant front</source>
        <translation>용장 정면</translation>
    </message>
    <message>
        <source>redundant back</source>
        <translation>용장 후면</translation>
    </message>
    <message>
        <source>previous step&apos;s form</source>
        <translation>이전 스텝의 형태</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>이 형태</translation>
    </message>
    <message>
        <source>L &lt; 180</source>
        <translation>L &lt; 180</translation>
    </message>
    <message>
        <source>L &gt;= 180</source>
        <translation>L &gt;= 180</translation>
    </message>
    <message>
        <source>U &lt; 180</source>
        <translation>U &lt; 180</translation>
    </message>
    <message>
        <source>U &gt;= 180</source>
        <translation>U &gt;= 180</translation>
    </message>
    <message>
        <source>B &lt; 180</source>
        <translation>B &lt; 180</translation>
    </message>
    <message>
        <source>B &gt;= 180</source>
        <translation>B &gt;= 180</translation>
    </message>
    <message>
        <source>E &lt; 180</source>
        <translation>E &lt; 180</translation>
    </message>
    <message>
        <source>E &gt;= 180</source>
        <translation>E &gt;= 180</translation>
    </message>
    <message>
        <source>W &lt; 180</source>
        <translation>W &lt; 180</translation>
    </message>
    <message>
        <source>W &gt;= 180</source>
        <translation>W &gt;= 180</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>펄스</translation>
    </message>
    <message>
        <source>base frame</source>
        <translation>베이스 좌표</translation>
    </message>
    <message>
        <source>robot frame</source>
        <translation>로봇 좌표</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>유저 좌표</translation>
    </message>
    <message>
        <source>tool frame</source>
        <translation>툴 좌표</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>그룹 %1</translation>
    </message>
    <message numerus="yes">
        <source>… (%n more characters)</source>
        <translation>
            <numerusform>… (외 %n자)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>variables::Sentences</name>
    <message>
        <source>Line %1: a cell begins with a quotation mark and does not end with one.</source>
        <translation>행 %1: 셀이 따옴표로 시작하지만 따옴표로 끝나지 않습니다.</translation>
    </message>
    <message>
        <source>Line %1: there is text behind the quotation mark that ends a cell.</source>
        <translation>행 %1: 셀을 닫는 따옴표 뒤에 문자가 있습니다.</translation>
    </message>
    <message>
        <source>The file is not UTF-8: save it as “CSV UTF-8” and try again.</source>
        <translation>파일이 UTF-8이 아닙니다. “CSV UTF-8”로 저장한 후 다시 시도하십시오.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”은(는) 숫자가 아닙니다.</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be from %2 to %3.</source>
        <translation>%1은(는) 범위를 벗어났습니다. %2부터 %3까지이어야 합니다.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number: write it without decimals and separators.</source>
        <translation>“%1”은(는) 정수가 아닙니다. 소수점과 구분 기호 없이 쓰십시오.</translation>
    </message>
    <message>
        <source>%1 does not go into a real: that is 0, or from ±1.18e-38 to ±3.40e+38.</source>
        <translation>%1은(는) 실수형에 들어가지 않습니다. 0 또는 ±1.18e-38부터 ±3.40e+38까지 가능합니다.</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>숫자가 아님</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>“%1”은(는) 정수가 아닙니다.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is too fine: %n decimal(s) are kept.</source>
        <translation>
            <numerusform>“%1”은(는) 너무 세밀합니다. 소수는 %n자리까지 유지됩니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is not a variable. Write its letter and its number, such as B007.</source>
        <translation>“%1”은(는) 변수가 아닙니다. B007과 같이 문자와 번호로 쓰십시오.</translation>
    </message>
    <message>
        <source>There is no %1: this controller has %2 to %3.</source>
        <translation>%1은(는) 없습니다. 이 컨트롤러에는 %2부터 %3까지 있습니다.</translation>
    </message>
    <message>
        <source>“%1” is not a range: it must go from a lower to a higher number of one kind.</source>
        <translation>“%1”은(는) 범위가 아닙니다. 같은 종류의 작은 번호에서 큰 번호까지이어야 합니다.</translation>
    </message>
    <message>
        <source>“%1” is not a type that %2 has.</source>
        <translation>“%1”은(는) %2에 없는 타입입니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>column: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing, and no value of this type was read.</source>
        <translation>%1이(가) 없고, 이 타입의 값도 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The type is missing, and none was read.</source>
        <translation>타입이 없고, 읽은 타입도 없습니다.</translation>
    </message>
    <message>
        <source>The variable is missing.</source>
        <translation>변수가 없습니다.</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1은(는) 읽기만 가능합니다.</translation>
    </message>
    <message>
        <source>%1 stands in line %2 already.</source>
        <translation>%1은(는) 이미 행 %2에 있습니다.</translation>
    </message>
    <message>
        <source>The value is missing.</source>
        <translation>값이 없습니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>variable: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The column “%1” stands there twice.</source>
        <translation>열 “%1”이(가) 2개 있습니다.</translation>
    </message>
    <message>
        <source>The header is missing: the first line must name the columns “variable” and “value”.</source>
        <translation>헤더가 없습니다. 첫 행에 열 이름 “variable”과 “value”가 있어야 합니다.</translation>
    </message>
    <message>
        <source>There is neither a column “value” nor “axis 1”.</source>
        <translation>열 “value”도 “axis 1”도 없습니다.</translation>
    </message>
    <message>
        <source>The line has more cells than the header.</source>
        <translation>이 행의 셀이 헤더보다 많습니다.</translation>
    </message>
    <message>
        <source>A block without a header has one or two columns.</source>
        <translation>헤더가 없는 블록은 1열 또는 2열입니다.</translation>
    </message>
    <message>
        <source>The text cannot be sent: %1.</source>
        <translation>이 텍스트는 송신할 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>The text must not hold the character NUL, which ends it.</source>
        <translation>텍스트에 끝을 나타내는 NUL 문자를 포함할 수 없습니다.</translation>
    </message>
    <message>
        <source>The text takes %1 bytes; there is room for %2.</source>
        <translation>텍스트는 %1바이트이나 %2바이트까지만 들어갑니다.</translation>
    </message>
    <message>
        <source>A position is not written as one text.</source>
        <translation>위치는 하나의 텍스트로 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>실수</translation>
    </message>
    <message numerus="yes">
        <source>up to %n byte(s)</source>
        <translation>
            <numerusform>최대 %n바이트</numerusform>
        </translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>펄스</translation>
    </message>
</context>
<context>
    <name>widgets::ArmControl</name>
    <message>
        <source>Hold for 1 s to arm</source>
        <translation>1초간 눌러 동작 허가</translation>
    </message>
    <message>
        <source>Why not?</source>
        <translation>불가한 이유는?</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>동작 허가 해제</translation>
    </message>
    <message>
        <source>Nobody is inside the fence</source>
        <translation>안전 펜스 안에 아무도 없습니다</translation>
    </message>
    <message>
        <source>I see the robot, or somebody who does</source>
        <translation>본인 또는 감시자가 로봇을 보고 있습니다</translation>
    </message>
    <message>
        <source>An emergency stop is within reach there</source>
        <translation>현장에서 비상 정지에 손이 닿습니다</translation>
    </message>
    <message>
        <source>Armed: start, servo on and moves are possible. It drops after a minute without key or mouse.</source>
        <translation>동작 허가 중: 기동, 서보 ON, 이동이 가능합니다. 1분간 키와 마우스 조작이 없으면 해제됩니다.</translation>
    </message>
    <message>
        <source>Disarmed at %1: %2.</source>
        <translation>%1에 동작 허가 해제됨: %2.</translation>
    </message>
    <message>
        <source>Tick all three first.</source>
        <translation>먼저 3개 모두 체크하십시오.</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>조건</translation>
    </message>
</context>
<context>
    <name>widgets::CellEditor</name>
    <message>
        <source>live: %1</source>
        <translation>실시간: %1</translation>
    </message>
</context>
<context>
    <name>widgets::ConditionList</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::ControllerTile</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
</context>
<context>
    <name>widgets::DiffView</name>
    <message>
        <source>Lines of both versions</source>
        <translation>두 버전의 행</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>행</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>이전 버전</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>새 버전</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>외 %n건</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::GoToEdit</name>
    <message>
        <source>Go to</source>
        <translation>바로 가기</translation>
    </message>
    <message>
        <source>Go to…  Ctrl+G</source>
        <translation>바로 가기…  Ctrl+G</translation>
    </message>
</context>
<context>
    <name>widgets::HoldButton</name>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (소프트웨어)</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>소프트웨어 홀드 · Pause 키</translation>
    </message>
</context>
<context>
    <name>widgets::JobView</name>
    <message>
        <source>Job text</source>
        <translation>잡 내용</translation>
    </message>
</context>
<context>
    <name>widgets::JogPad</name>
    <message>
        <source>Jog %1 forward</source>
        <translation>%1 정방향 조그</translation>
    </message>
    <message>
        <source>Jog %1 back</source>
        <translation>%1 역방향 조그</translation>
    </message>
</context>
<context>
    <name>widgets::LogicStrip</name>
    <message>
        <source>The watched signals over the last minute</source>
        <translation>최근 1분간의 워치 중인 신호</translation>
    </message>
    <message>
        <source>now</source>
        <translation>현재</translation>
    </message>
    <message>
        <source>−%1 s</source>
        <translation>−%1초</translation>
    </message>
</context>
<context>
    <name>widgets::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>이 메시지 닫기</translation>
    </message>
</context>
<context>
    <name>widgets::OrderButton</name>
    <message>
        <source>Why not?</source>
        <translation>불가한 이유는?</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>조건</translation>
    </message>
    <message>
        <source>Conditions of: %1</source>
        <translation>%1의 조건</translation>
    </message>
    <message>
        <source>Pending…</source>
        <translation>처리 중…</translation>
    </message>
</context>
<context>
    <name>widgets::Plot</name>
    <message>
        <source>seconds</source>
        <translation>초</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>플롯</translation>
    </message>
    <message>
        <source>Nothing is plotted.</source>
        <translation>플롯이 없습니다.</translation>
    </message>
</context>
<context>
    <name>widgets::Plottables</name>
    <message>
        <source>Add to trend: %1</source>
        <translation>트렌드에 추가: %1</translation>
    </message>
</context>
<context>
    <name>widgets::Question</name>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>확인</translation>
    </message>
</context>
<context>
    <name>widgets::Rows</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::Segments</name>
    <message>
        <source>%1: %2</source>
        <comment>what is chosen: the choice</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::Sparkline</name>
    <message>
        <source>Round trips of the last 60 seconds: none yet.</source>
        <translation>최근 60초의 왕복 시간: 아직 없습니다.</translation>
    </message>
    <message>
        <source>Round trips of the last 60 seconds: longest %1 ms, lost tries in %2 s.</source>
        <translation>최근 60초의 왕복 시간: 최장 %1 ms, %2초에 손실 있음.</translation>
    </message>
</context>
<context>
    <name>widgets::ToolPathView</name>
    <message>
        <source>Top</source>
        <translation>윗면</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>정면</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>측면</translation>
    </message>
    <message>
        <source>Tool path, %1 view</source>
        <translation>툴 궤적, %1 보기</translation>
    </message>
    <message>
        <source>No position in the base frame was read yet.</source>
        <translation>아직 베이스 좌표의 위치를 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 %2 mm, %3 %4 mm. %5</source>
        <translation>%1 %2 mm, %3 %4 mm. %5</translation>
    </message>
    <message>
        <source>%1  ·  %2 →  %3 ↑</source>
        <translation>%1  ·  %2 →  %3 ↑</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>widgets::ValueGrid</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>widgets::ValueLabel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
</TS>

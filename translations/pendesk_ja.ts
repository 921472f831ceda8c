<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source> or </source>
        <translation> または </translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (ソフトウェア)</translation>
    </message>
    <message>
        <source>Access level…</source>
        <translation>アクセスレベル…</translation>
    </message>
    <message>
        <source>Open this page in its own window</source>
        <translation>このページを別ウィンドウで開く</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>接続…</translation>
    </message>
    <message>
        <source>Connect to this controller</source>
        <translation>このコントローラに接続</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>デモを開く</translation>
    </message>
    <message>
        <source>Diagnose…</source>
        <translation>診断…</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>診断をコピー</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Pendeskについて</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Language and look…</source>
        <translation>言語と外観…</translation>
    </message>
    <message>
        <source>Readiness…</source>
        <translation>準備状態…</translation>
    </message>
    <message>
        <source>Help and shortcuts</source>
        <translation>ヘルプとショートカット</translation>
    </message>
</context>
<context>
    <name>Alarms</name>
    <message>
        <source>Major</source>
        <translation>重故障</translation>
    </message>
    <message>
        <source>Minor</source>
        <translation>軽故障</translation>
    </message>
    <message>
        <source>User, system</source>
        <translation>ユーザ (システム)</translation>
    </message>
    <message>
        <source>User</source>
        <translation>ユーザ</translation>
    </message>
    <message>
        <source>Off-line</source>
        <translation>オフライン</translation>
    </message>
    <message>
        <source>◆ unacknowledged</source>
        <translation>◆ 未確認</translation>
    </message>
    <message>
        <source>■ acknowledged</source>
        <translation>■ 確認済み</translation>
    </message>
    <message>
        <source>▲ cleared, unacknowledged</source>
        <translation>▲ 解除済み、未確認</translation>
    </message>
    <message>
        <source>□ cleared</source>
        <translation>□ 解除済み</translation>
    </message>
    <message>
        <source>No sub code.</source>
        <translation>サブコードなし。</translation>
    </message>
    <message>
        <source>%1: %2. As sent: %3, type %4.</source>
        <translation>%1: %2。受信値: %3、タイプ %4。</translation>
    </message>
</context>
<context>
    <name>Conditions</name>
    <message>
        <source>%1: %2.</source>
        <comment>what is wrong: what helps</comment>
        <translation>%1: %2。</translation>
    </message>
    <message>
        <source>met</source>
        <translation>成立</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>不成立</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>未読出し</translation>
    </message>
    <message>
        <source>cannot be read over HSES</source>
        <translation>HSESでは読出し不可</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what was tried: how it ended</comment>
        <translation>%1: %2。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>動作許可</translation>
    </message>
    <message>
        <source>Reset alarm</source>
        <translation>アラームリセット</translation>
    </message>
    <message>
        <source>Cancel error</source>
        <translation>エラーキャンセル</translation>
    </message>
    <message>
        <source>Write a signal</source>
        <translation>信号の書込み</translation>
    </message>
    <message>
        <source>Write a register</source>
        <translation>レジスタの書込み</translation>
    </message>
    <message>
        <source>Write a variable</source>
        <translation>変数の書込み</translation>
    </message>
    <message>
        <source>Select a job</source>
        <translation>ジョブの選択</translation>
    </message>
    <message>
        <source>Select a master job</source>
        <translation>マスタジョブの選択</translation>
    </message>
    <message>
        <source>Start the job</source>
        <translation>ジョブの起動</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (ソフトウェア)</translation>
    </message>
    <message>
        <source>Release HOLD</source>
        <translation>HOLDの解除</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>サーボオン</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>サーボオフ</translation>
    </message>
    <message>
        <source>HLOCK on</source>
        <translation>HLOCKオン</translation>
    </message>
    <message>
        <source>HLOCK off</source>
        <translation>HLOCKオフ</translation>
    </message>
    <message>
        <source>Select the cycle mode</source>
        <translation>サイクルモードの選択</translation>
    </message>
    <message>
        <source>Show a message on the pendant</source>
        <translation>ペンダントへのメッセージ表示</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Send a file to the controller</source>
        <translation>コントローラへのファイル送信</translation>
    </message>
    <message>
        <source>Get a file from the controller</source>
        <translation>コントローラからのファイル取得</translation>
    </message>
    <message>
        <source>Delete a file on the controller</source>
        <translation>コントローラのファイル削除</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>バックアップの復元</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>監視</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>技術者</translation>
    </message>
    <message>
        <source>disarmed by hand</source>
        <translation>手動で解除</translation>
    </message>
    <message>
        <source>nobody used key or mouse for a minute</source>
        <translation>1分間キーもマウスも操作なし</translation>
    </message>
    <message>
        <source>another program came to the front</source>
        <translation>別のプログラムが前面に表示</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>画面がロックされた</translation>
    </message>
    <message>
        <source>communication was lost</source>
        <translation>通信が途絶</translation>
    </message>
    <message>
        <source>the mode changed at the controller</source>
        <translation>コントローラでモードが変更された</translation>
    </message>
    <message>
        <source>an alarm came up</source>
        <translation>アラームが発生</translation>
    </message>
    <message>
        <source>the access level fell back</source>
        <translation>アクセスレベルが戻った</translation>
    </message>
    <message>
        <source>another window came to the front</source>
        <translation>別のウィンドウが前面に表示</translation>
    </message>
    <message>
        <source>another controller was armed</source>
        <translation>別のコントローラが動作許可になった</translation>
    </message>
    <message>
        <source>The link to the controller is up</source>
        <translation>コントローラとのリンクが確立しています</translation>
    </message>
    <message>
        <source>The access level is Operate or Engineer</source>
        <translation>アクセスレベルが「操作」または「技術者」です</translation>
    </message>
    <message>
        <source>The access level is Engineer</source>
        <translation>アクセスレベルが「技術者」です</translation>
    </message>
    <message>
        <source>The status is fresh</source>
        <translation>状態の情報が最新です</translation>
    </message>
    <message>
        <source>This controller is armed</source>
        <translation>このコントローラは動作許可中です</translation>
    </message>
    <message>
        <source>REMOTE is on</source>
        <translation>REMOTEがオンです</translation>
    </message>
    <message>
        <source>The mode is PLAY</source>
        <translation>モードがPLAYです</translation>
    </message>
    <message>
        <source>The mode is not TEACH</source>
        <translation>モードがTEACHではありません</translation>
    </message>
    <message>
        <source>There is no alarm</source>
        <translation>アラームはありません</translation>
    </message>
    <message>
        <source>There is no error</source>
        <translation>エラーはありません</translation>
    </message>
    <message>
        <source>Not held by the pendant</source>
        <translation>ペンダントによるホールドなし</translation>
    </message>
    <message>
        <source>Not held by an external signal</source>
        <translation>外部信号によるホールドなし</translation>
    </message>
    <message>
        <source>Not held by a command</source>
        <translation>コマンドによるホールドなし</translation>
    </message>
    <message>
        <source>Held by a command</source>
        <translation>コマンドによるホールド中</translation>
    </message>
    <message>
        <source>Servo power is on</source>
        <translation>サーボ電源がオンです</translation>
    </message>
    <message>
        <source>No job is running</source>
        <translation>運転中のジョブはありません</translation>
    </message>
    <message>
        <source>A job is selected</source>
        <translation>ジョブが選択されています</translation>
    </message>
    <message>
        <source>The numbering of variables is verified</source>
        <translation>変数番号の方式が照合済みです</translation>
    </message>
    <message>
        <source>The model takes move orders</source>
        <translation>この機種は移動命令を受け付けます</translation>
    </message>
    <message>
        <source>The safety circuit is closed</source>
        <translation>安全回路が閉じています</translation>
    </message>
    <message>
        <source>Not held by a playback panel</source>
        <translation>プレイバックパネルによるホールドなし</translation>
    </message>
    <message>
        <source>Home position and position check are confirmed</source>
        <translation>原点位置と位置確認が完了しています</translation>
    </message>
    <message>
        <source>Starting is not locked at the panel</source>
        <translation>起動はパネルでロックされていません</translation>
    </message>
    <message>
        <source>Mode and cycle are not locked at the panel</source>
        <translation>モードとサイクルはパネルでロックされていません</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is permitted</source>
        <translation>REMOTEとPLAYでのジョブ選択が許可されています</translation>
    </message>
    <message>
        <source>Changing the master job is permitted</source>
        <translation>マスタジョブの変更が許可されています</translation>
    </message>
    <message>
        <source>The job exists on the controller</source>
        <translation>ジョブがコントローラにあります</translation>
    </message>
    <message>
        <source>Nothing is being edited at the pendant</source>
        <translation>ペンダントで編集中のものはありません</translation>
    </message>
    <message>
        <source>No other function uses the files</source>
        <translation>ほかの機能がファイルを使用していません</translation>
    </message>
    <message>
        <source>The data are not protected</source>
        <translation>データは保護されていません</translation>
    </message>
    <message>
        <source>Replacing existing files is permitted</source>
        <translation>既存ファイルの置換えが許可されています</translation>
    </message>
    <message>
        <source>There is no link to the controller</source>
        <translation>コントローラとのリンクがありません</translation>
    </message>
    <message>
        <source>connect, or wait until it answers again</source>
        <translation>接続するか、再び応答するまで待ってください</translation>
    </message>
    <message>
        <source>The access level is Monitor</source>
        <translation>アクセスレベルが「監視」です</translation>
    </message>
    <message>
        <source>switch to Operate in the strip (Ctrl+L)</source>
        <translation>状態バーで「操作」に切り替えてください (Ctrl+L)</translation>
    </message>
    <message>
        <source>The access level is not Engineer</source>
        <translation>アクセスレベルが「技術者」ではありません</translation>
    </message>
    <message>
        <source>switch to Engineer in the strip (Ctrl+L)</source>
        <translation>状態バーで「技術者」に切り替えてください (Ctrl+L)</translation>
    </message>
    <message>
        <source>The status was not read just now</source>
        <translation>状態の情報が最新ではありません</translation>
    </message>
    <message>
        <source>wait a moment; if it stays so, look at the link</source>
        <translation>少し待ってください。変わらない場合はリンクを確認してください</translation>
    </message>
    <message>
        <source>This controller is not armed</source>
        <translation>このコントローラは動作許可になっていません</translation>
    </message>
    <message>
        <source>arm it on this page</source>
        <translation>このページで動作許可にしてください</translation>
    </message>
    <message>
        <source>REMOTE is off</source>
        <translation>REMOTEがオフです</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1</source>
        <translation>ペンダントのモードキーをREMOTEにし、CMD REMOTE SELをオンにしてください: %1</translation>
    </message>
    <message>
        <source>The mode is not PLAY</source>
        <translation>モードがPLAYではありません</translation>
    </message>
    <message>
        <source>turn the pendant key to PLAY or REMOTE</source>
        <translation>ペンダントのモードキーをPLAYまたはREMOTEにしてください</translation>
    </message>
    <message>
        <source>The controller is in TEACH</source>
        <translation>コントローラがTEACHです</translation>
    </message>
    <message>
        <source>the person at the pendant has the robot: turn the key to REMOTE when that is over</source>
        <translation>ペンダントの操作者がロボットを操作中です。終わってからモードキーをREMOTEにしてください</translation>
    </message>
    <message>
        <source>There is an alarm</source>
        <translation>アラームが発生しています</translation>
    </message>
    <message>
        <source>remove its cause, then reset it on the Alarms page</source>
        <translation>原因を取り除いてから、「アラーム」ページでリセットしてください</translation>
    </message>
    <message>
        <source>There is an error</source>
        <translation>エラーが発生しています</translation>
    </message>
    <message>
        <source>read it on the Alarms page, then cancel it</source>
        <translation>「アラーム」ページで内容を確認してから、エラーキャンセルを行ってください</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>ペンダントによるホールド中</translation>
    </message>
    <message>
        <source>release it there</source>
        <translation>ペンダントで解除してください</translation>
    </message>
    <message>
        <source>Held by an external signal</source>
        <translation>外部信号によるホールド中</translation>
    </message>
    <message>
        <source>release it where that signal comes from</source>
        <translation>その信号の発生元で解除してください</translation>
    </message>
    <message>
        <source>release HOLD on the Jobs page</source>
        <translation>「ジョブ」ページでHOLDを解除してください</translation>
    </message>
    <message>
        <source>No command holds the robot</source>
        <translation>コマンドによるホールドはありません</translation>
    </message>
    <message>
        <source>there is nothing to release from here</source>
        <translation>ここから解除するものはありません</translation>
    </message>
    <message>
        <source>Servo power is off</source>
        <translation>サーボ電源がオフです</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>サーボをオンにしてください</translation>
    </message>
    <message>
        <source>A job is running</source>
        <translation>ジョブが運転中です</translation>
    </message>
    <message>
        <source>wait until it has ended, or hold it</source>
        <translation>終了するまで待つか、ホールドしてください</translation>
    </message>
    <message>
        <source>No job is selected</source>
        <translation>ジョブが選択されていません</translation>
    </message>
    <message>
        <source>select one on the Jobs page</source>
        <translation>「ジョブ」ページでジョブを選択してください</translation>
    </message>
    <message>
        <source>The numbering of variables is not verified</source>
        <translation>変数番号の方式が未照合です</translation>
    </message>
    <message>
        <source>compare two variables with the pendant (Variables page)</source>
        <translation>2つの変数をペンダントと比較してください (「変数」ページ)</translation>
    </message>
    <message>
        <source>This model takes no move orders</source>
        <translation>この機種は移動命令を受け付けません</translation>
    </message>
    <message>
        <source>move it with the pendant</source>
        <translation>ペンダントで動かしてください</translation>
    </message>
    <message>
        <source>The safety circuit is open</source>
        <translation>安全回路が開いています</translation>
    </message>
    <message>
        <source>look at emergency stops, doors and the enabling switch</source>
        <translation>非常停止、扉、イネーブルスイッチを確認してください</translation>
    </message>
    <message>
        <source>Held by a playback panel</source>
        <translation>プレイバックパネルによるホールド中</translation>
    </message>
    <message>
        <source>Home position or position check is missing</source>
        <translation>原点位置または位置確認が完了していません</translation>
    </message>
    <message>
        <source>confirm the position at the pendant</source>
        <translation>ペンダントで位置確認を行ってください</translation>
    </message>
    <message>
        <source>Starting is locked at the panel</source>
        <translation>起動がパネルでロックされています</translation>
    </message>
    <message>
        <source>release the start lock (I/O or panel prohibit) at the cell</source>
        <translation>セルで起動ロック (I/Oまたはパネルの禁止) を解除してください</translation>
    </message>
    <message>
        <source>Mode and cycle are locked at the panel</source>
        <translation>モードとサイクルがパネルでロックされています</translation>
    </message>
    <message>
        <source>release the panel lock (I/O or panel prohibit) at the cell</source>
        <translation>セルでパネルロック (I/Oまたはパネルの禁止) を解除してください</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is prohibited</source>
        <translation>REMOTEとPLAYでのジョブ選択が禁止されています</translation>
    </message>
    <message>
        <source>set “job select when remote and play” to permit: %1</source>
        <translation>“job select when remote and play” (リモート・プレイ時のジョブ選択) を許可にしてください: %1</translation>
    </message>
    <message>
        <source>Changing the master job is prohibited</source>
        <translation>マスタジョブの変更が禁止されています</translation>
    </message>
    <message>
        <source>permit it at the pendant (master call, teach lock): %1</source>
        <translation>ペンダントで許可してください (マスタ呼出し、ティーチロック): %1</translation>
    </message>
    <message>
        <source>The job is not on the controller</source>
        <translation>ジョブがコントローラにありません</translation>
    </message>
    <message>
        <source>read the list of jobs again</source>
        <translation>ジョブの一覧を読み出し直してください</translation>
    </message>
    <message>
        <source>Something is being edited at the pendant</source>
        <translation>ペンダントで編集中です</translation>
    </message>
    <message>
        <source>leave the editor there</source>
        <translation>ペンダントで編集画面を閉じてください</translation>
    </message>
    <message>
        <source>Another function uses the files</source>
        <translation>別の機能がファイルを使用しています</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>しばらくしてからやり直してください</translation>
    </message>
    <message>
        <source>The data are protected</source>
        <translation>データが保護されています</translation>
    </message>
    <message>
        <source>release the protection at the pendant</source>
        <translation>ペンダントで保護を解除してください</translation>
    </message>
    <message>
        <source>Replacing files is not permitted</source>
        <translation>ファイルの置換えが許可されていません</translation>
    </message>
    <message>
        <source>set the parameters RS029 and RS214 to 1: %1</source>
        <translation>パラメータRS029とRS214を1に設定してください: %1</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or FUNCTION ENABLE</source>
        <translation>SETUP、FUNCTION COND.またはFUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE</source>
        <translation>SETUP、FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or TEACHING COND.</source>
        <translation>SETUP、FUNCTION COND.またはTEACHING COND.</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE or TEACHING COND.</source>
        <translation>SETUP、FUNCTION ENABLEまたはTEACHING COND.</translation>
    </message>
    <message>
        <source>PARAMETER, RS (management mode)</source>
        <translation>PARAMETER、RS (管理モード)</translation>
    </message>
    <message>
        <source>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)</source>
        <translation>IN/OUT、PSEUDO INPUT SIG、CMD REMOTE SEL (DX100では#82015)</translation>
    </message>
    <message>
        <source>The controller shows an error</source>
        <translation>コントローラがエラーを表示しています</translation>
    </message>
    <message>
        <source>The controller shows no error</source>
        <translation>コントローラはエラーを表示していません</translation>
    </message>
    <message>
        <source>there is nothing to cancel</source>
        <translation>キャンセルするものはありません</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>接続が閉じられた</translation>
    </message>
    <message>
        <source>the language was changed</source>
        <translation>言語が変更された</translation>
    </message>
    <message>
        <source>the window was turned to another controller</source>
        <translation>ウィンドウが別のコントローラに切り替えられた</translation>
    </message>
    <message>
        <source>the computer went to sleep</source>
        <translation>コンピュータがスリープした</translation>
    </message>
    <message>
        <source>this program stood still, or the computer&apos;s clock jumped</source>
        <translation>このプログラムが停止していたか、コンピュータの時計が飛んだ</translation>
    </message>
</context>
<context>
    <name>FileSheet</name>
    <message>
        <source>There is no “%1”.</source>
        <translation>「%1」がありません。</translation>
    </message>
    <message>
        <source>There is no folder “%1”.</source>
        <translation>フォルダ「%1」がありません。</translation>
    </message>
    <message>
        <source>“%1” exists already. Is it to be replaced?</source>
        <translation>「%1」はすでにあります。置き換えますか?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置換え</translation>
    </message>
</context>
<context>
    <name>LinkView</name>
    <message>
        <source>checking</source>
        <translation>確認中</translation>
    </message>
    <message>
        <source>live</source>
        <translation>ライブ</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>通信途絶</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未接続</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Diagnose…</source>
        <translation>診断…</translation>
    </message>
    <message>
        <source>HOLD not confirmed: use the pendant.</source>
        <translation>HOLDを確認できません。ペンダントを使ってください。</translation>
    </message>
    <message>
        <source>HOLD was refused: %1. Use the pendant.</source>
        <translation>HOLDは拒否されました: %1。ペンダントを使ってください。</translation>
    </message>
    <message>
        <source>No contact with %1 yet: %2. Checking goes on by itself.</source>
        <translation>まだ%1と通信できません: %2。確認は自動で続きます。</translation>
    </message>
    <message>
        <source>Checking %1: waiting for system information and status.</source>
        <translation>%1を確認中: システム情報と状態を待っています。</translation>
    </message>
    <message>
        <source>Communication lost at %1 — showing the last values read. Reading resumes by itself.</source>
        <translation>通信途絶 (%1) — 最後に読み出した値を表示しています。読出しは自動で再開します。</translation>
    </message>
    <message numerus="yes">
        <source>Communication restored at %1. Lost %n time(s) since connecting.</source>
        <translation>
            <numerusform>通信が復旧しました (%1)。接続してから%n回途絶しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>HOLD was not sent: there is no connection to a controller. Use the pendant.</source>
        <translation>HOLDは送信していません: コントローラと接続していません。ペンダントを使ってください。</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>接続…</translation>
    </message>
</context>
<context>
    <name>Noise</name>
    <message>
        <source>Date of the last change of a job (///DATE)</source>
        <translation>ジョブの最終変更日時 (///DATE)</translation>
    </message>
    <message>
        <source>Dates and times of day, such as 2026/01/31 08:30</source>
        <translation>日付と時刻 (例: 2026/01/31 08:30)</translation>
    </message>
    <message>
        <source>Operating time counters, such as 18:19&apos;02</source>
        <translation>稼働時間カウンタ (例: 18:19&apos;02)</translation>
    </message>
    <message>
        <source>Blanks at the end of a line</source>
        <translation>行末の空白</translation>
    </message>
    <message>
        <source>Line ends: CR LF or LF, and whether the last line has one</source>
        <translation>改行 (CR LFまたはLF) と、最終行の改行の有無</translation>
    </message>
</context>
<context>
    <name>OrderRecords</name>
    <message>
        <source>✓ done</source>
        <translation>✓ 完了</translation>
    </message>
    <message>
        <source>✗ refused</source>
        <translation>✗ 拒否</translation>
    </message>
    <message>
        <source>▲ unknown</source>
        <translation>▲ 不明</translation>
    </message>
    <message>
        <source>□ not sent</source>
        <translation>□ 未送信</translation>
    </message>
    <message>
        <source>□ cancelled</source>
        <translation>□ 中止しました</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>kept on this computer</source>
        <translation>このコンピュータに保存</translation>
    </message>
    <message>
        <source>the last values read before %1</source>
        <translation>%1より前の最後の読出し値</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Overview</source>
        <translation>概要</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>I/O</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>レジスタ</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>ジョグと移動</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>トレンド</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>操作履歴</translation>
    </message>
    <message>
        <source>The state of the robot at a glance: mode, cycle, servo, run, the three causes of a hold, alarm, error and speed limit, the executing job, the position of R1, and how well the link works.</source>
        <translation>ロボットの状態の一覧です。モード、サイクル、サーボ、運転、3つのホールド元、アラーム、エラー、速度制限、実行中のジョブ、R1の位置、リンクの良否を表示します。</translation>
    </message>
    <message>
        <source>“What can I do now?” lists what may be ordered. ✓ may be tried, ✗ may not, with the first reason beside it.</source>
        <translation>「今できること」は、出せる指令の一覧です。✓は試みることができ、✗はできません。✗の横に最初の理由を示します。</translation>
    </message>
    <message>
        <source>Bits that contradict each other, such as TEACH and PLAY, are shown side by side as they were received, under ▲.</source>
        <translation>TEACHとPLAYのように互いに矛盾するビットは、受信したまま▲を付けて並べて表示します。</translation>
    </message>
    <message>
        <source>Copy beside the system information takes model and software to the clipboard. The right mouse button on a number adds it to the trend.</source>
        <translation>システム情報の横の「コピー」は、機種とソフトウェアをクリップボードにコピーします。数値を右クリックすると、トレンドに追加できます。</translation>
    </message>
    <message>
        <source>Up to four active alarms, the newest first, and the past alarms that were read from the controller.</source>
        <translation>発生中のアラーム (最大4つ、新しい順) と、コントローラから読み出した過去のアラームです。</translation>
    </message>
    <message>
        <source>Acknowledge is noted on this computer only: the robot does not hear of it.</source>
        <translation>「確認」はこのコンピュータだけに記録します。ロボットには伝わりません。</translation>
    </message>
    <message>
        <source>Reset alarm and Cancel error are orders: they need REMOTE and the level Operate, and say before what they clear. After a reset that was accepted an alarm may stay: then its cause is still there.</source>
        <translation>「アラームリセット」と「エラーキャンセル」は指令です。REMOTEとレベル「操作」が必要で、何を解除するかを事前に示します。リセットが受け付けられてもアラームが残ることがあります。その場合は原因がまだ残っています。</translation>
    </message>
    <message>
        <source>Read now fetches the history and keeps it in the journal, even after the controller has dropped it. Most frequent counts codes.</source>
        <translation>「今すぐ読出し」は履歴を読み出し、操作履歴に保存します。コントローラから消えた後も残ります。「発生頻度順」はコードごとに回数を数えます。</translation>
    </message>
    <message>
        <source>Notes keep what caused a code and what was done, on this computer.</source>
        <translation>「メモ」は、コードの原因と処置内容をこのコンピュータに保存します。</translation>
    </message>
    <message>
        <source>All signals of one area, a group of eight in a row. A filled square is 1, a hollow one 0; a frame marks what changed in the last two seconds.</source>
        <translation>1つの範囲のすべての信号を、8つのグループごとに1行で表示します。塗りつぶしの四角は1、中空の四角は0です。枠は直近2秒間に変わったものを示します。</translation>
    </message>
    <message>
        <source>Only network inputs can be written over HSES, by an engineer. A write reads the group, changes one bit, shows old and new, and reads back: eight bits travel together.</source>
        <translation>HSESで書き込めるのはネットワーク入力だけで、レベル「技術者」が必要です。書込みでは、グループを読み出し、1ビットを変え、現在の値と新しい値を表示し、書き込んだ後に読み戻します。8ビットは一括で送信します。</translation>
    </message>
    <message>
        <source>Names come from the controller&apos;s IONAME.DAT. The right mouse button names a signal here, or puts it on the tab Watch.</source>
        <translation>名称はコントローラのIONAME.DATから取得します。信号を右クリックすると、ここで名称を付けるか、「ウォッチ」タブに追加できます。</translation>
    </message>
    <message>
        <source>Watch counts edges and draws the last minute. It reads four times a second: shorter pulses are not seen.</source>
        <translation>「ウォッチ」はエッジを数え、直近1分間を描画します。読出しは毎秒4回です。それより短いパルスは検出しません。</translation>
    </message>
    <message>
        <source>Go to takes #27010 as well as IN#(1).</source>
        <translation>「ジャンプ」には、#27010の形でもIN#(1)の形でも入力できます。</translation>
    </message>
    <message>
        <source>The registers M000 to M999, as decimal, signed, hexadecimal or binary numbers. Only the rows in view are read.</source>
        <translation>レジスタM000からM999までを、10進、符号付き、16進、2進で表示します。表示中の行だけを読み出します。</translation>
    </message>
    <message>
        <source>M000 to M559 can be written by an engineer; the others belong to the ladder.</source>
        <translation>M000からM559までは、レベル「技術者」で書き込めます。ほかはラダーが使います。</translation>
    </message>
    <message>
        <source>Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back.</source>
        <translation>入力欄でEnterを押すと、値を書込み予定に追加します。値は橙色になり、まだ何も送信しません。「適用」は、書込み予定のすべての値の現在の値と新しい値を表示し、それぞれ1回だけ書き込み、読み戻します。</translation>
    </message>
    <message>
        <source>A value that reads back differently is red and stays. Undo last stages the values from before the last Apply.</source>
        <translation>書き込んだ値と異なる値が読み戻された場合、その値は赤で残ります。「直前の書込みを戻す」は、直前の「適用」の前の値を書込み予定に追加します。</translation>
    </message>
    <message>
        <source>The variables B I D R S P BP and EX with their names, their value before, and when they changed. Only the rows in view are read.</source>
        <translation>変数B I D R S P BP EXを、名称、前回の値、変更時刻とともに表示します。表示中の行だけを読み出します。</translation>
    </message>
    <message>
        <source>Nothing is written before the numbering was compared with the pendant: Verify… does that, and only reads.</source>
        <translation>変数番号の方式をペンダントと比較するまで、何も書き込みません。「照合…」がその比較を行います。読出しだけを行います。</translation>
    </message>
    <message>
        <source>Import and Export take CSV files; cells of a spreadsheet can be pasted. Both show first what would differ.</source>
        <translation>「インポート」と「エクスポート」はCSVファイルを扱います。表計算ソフトのセルを貼り付けることもできます。インポートと貼付けでは、異なる内容を先に表示します。</translation>
    </message>
    <message>
        <source>A watch page is a list of your own: the right mouse button puts rows of any tab on it.</source>
        <translation>ウォッチページは自分で作る一覧です。どのタブの行も、右クリックで追加できます。</translation>
    </message>
    <message>
        <source>The tool point in the base frame, with form and tool; the axes in pulses with following error, torque and temperature where the model tells them; and the path of the tool point.</source>
        <translation>ベース座標の制御点と、その形態およびツール。パルスでの各軸と、機種が知らせる場合は位置偏差、トルク、温度。制御点の軌跡を表示します。</translation>
    </message>
    <message>
        <source>Degrees of axes stand here only where the profile gives pulses per degree: the controller does not tell them.</source>
        <translation>軸の角度 (度) は、プロファイルに1度あたりのパルス数がある場合だけ表示します。コントローラはこれを知らせません。</translation>
    </message>
    <message>
        <source>Torque is shown as the controller sends it: its unit is stated nowhere.</source>
        <translation>トルクはコントローラが送ったままの値です。単位はどこにも示されていません。</translation>
    </message>
    <message>
        <source>Min and max count from the last reset, while this page is read. Copy as text takes the table in view.</source>
        <translation>最小と最大は、最後のリセット以降、このページを読み出している間の値です。「テキストとしてコピー」は、表示中の表をコピーします。</translation>
    </message>
    <message>
        <source>Control groups that the controller refuses have no tab; the line beside the tabs counts them.</source>
        <translation>コントローラが拒否した制御グループにはタブがありません。タブの横の行にその数を示します。</translation>
    </message>
    <message>
        <source>Moves the robot by orders, in automatic operation. The pendant&apos;s enabling switch does not protect anyone here, and nobody may be inside the fence. It is off in TEACH, always.</source>
        <translation>自動運転で、指令によってロボットを動かします。ここではペンダントのイネーブルスイッチは誰も保護しません。安全柵の中に人がいてはいけません。TEACHでは常にオフです。</translation>
    </message>
    <message>
        <source>Arming needs the level Operate, REMOTE and PLAY; moving needs Engineer too. Losing the focus, a minute without a key or the mouse, an alarm or a lost link disarms.</source>
        <translation>動作許可にするには、レベル「操作」、REMOTE、PLAYが必要です。移動には、レベル「技術者」であることも必要です。フォーカスを失う、1分間キーもマウスも操作がない、アラームが発生する、通信が途絶する、のいずれかで動作許可は解除されます。</translation>
    </message>
    <message>
        <source>Jog sends one bounded step after another while a button is held. Letting go sends no more steps and holds the one that runs; after a lost link the robot still ends its step.</source>
        <translation>「ジョグ」は、ボタンを押している間、範囲を限ったステップを1つずつ続けて送信します。ボタンを離すと、以後のステップは送信せず、実行中のステップをホールドします。通信が途絶した場合、ロボットは実行中のステップを最後まで動きます。</translation>
    </message>
    <message>
        <source>Move shows present place, target and change first. Rehearse… opens the sheet on which the move is confirmed.</source>
        <translation>「移動」は、先に現在の位置、目標、変化を表示します。「事前確認…」は、移動の実行を確認する画面を開きます。</translation>
    </message>
    <message>
        <source>What was sent without an answer is called unknown, never failed: look at the robot.</source>
        <translation>送信して応答がないものは「不明」とし、失敗とは扱いません。ロボットを確認してください。</translation>
    </message>
    <message>
        <source>Draws any number over time. Drag it here from a page, choose “Add to trend” in its menu, or use Add signal….</source>
        <translation>任意の数値を時間に沿って描画します。ページからここへドラッグするか、そのメニューで「トレンドに追加」を選ぶか、「信号を追加…」を使ってください。</translation>
    </message>
    <message>
        <source>Pause freezes the view; recording goes on. Gaps in a curve are times in which nothing was read.</source>
        <translation>「一時停止」は表示を止めます。記録は続きます。曲線の途切れは、何も読み出していない時間です。</translation>
    </message>
    <message>
        <source>The time box chooses how long a time is in view; under the cursor stand the values of that moment.</source>
        <translation>「表示時間」の欄で、表示する時間の長さを選びます。カーソルの下に、その時点の値を表示します。</translation>
    </message>
    <message>
        <source>An incident keeps 60 s before and 20 s after an alarm came up. It can be opened here later.</source>
        <translation>インシデントは、アラーム発生の60秒前から20秒後までを保存します。後からここで開けます。</translation>
    </message>
    <message>
        <source>Export CSV… writes what is in view, with times in UTC.</source>
        <translation>「CSVエクスポート…」は、表示範囲をUTCの時刻で書き出します。</translation>
    </message>
    <message>
        <source>The jobs on the controller and the text of the chosen one, with the line that is executed. A banner says when the text may be old.</source>
        <translation>コントローラのジョブと、選んだジョブの内容を、実行中の行とともに表示します。内容が古い可能性があるときは、上部に表示で知らせます。</translation>
    </message>
    <message>
        <source>Start needs REMOTE, PLAY, servo on, the level Operate and an armed controller. Its sheet names controller, job and line, and the button works after one second. Nothing is ever started twice.</source>
        <translation>「起動」には、REMOTE、PLAY、サーボオン、レベル「操作」、コントローラの動作許可が必要です。確認画面にコントローラ、ジョブ、行を表示し、ボタンは1秒後に有効になります。二重に起動することはありません。</translation>
    </message>
    <message>
        <source>Buttons show what was read. “Pending” stands until the status agrees.</source>
        <translation>ボタンは読み出した状態を示します。状態が一致するまで「処理中」と表示します。</translation>
    </message>
    <message>
        <source>HOLD from here can be released here. A hold by the pendant is released there.</source>
        <translation>ここからのHOLDは、ここで解除できます。ペンダントによるホールドは、ペンダントで解除します。</translation>
    </message>
    <message>
        <source>“Why not?” beside a button lists all its conditions.</source>
        <translation>ボタンの横の「できない理由は?」は、その条件をすべて表示します。</translation>
    </message>
    <message>
        <source>Files of this computer on the left, of the controller on the right, by type.</source>
        <translation>左にこのコンピュータのファイル、右にコントローラのファイルを、タイプごとに表示します。</translation>
    </message>
    <message>
        <source>Fetch only reads. Send and Delete are for engineers and need REMOTE on.</source>
        <translation>「取得」は読出しだけを行います。「送信」と「削除」にはレベル「技術者」が必要で、REMOTEがオンでなければなりません。</translation>
    </message>
    <message>
        <source>A file that exists already is asked about: compare it, replace it, or leave it, which is the default. A file cut off half way never replaces a good one.</source>
        <translation>ファイルがすでにある場合は、比較する、置き換える、そのままにする (既定) のどれにするかを確認します。途中で切れたファイルが正常なファイルを置き換えることはありません。</translation>
    </message>
    <message>
        <source>Before a job is sent its text is checked, and afterwards it is read back and compared.</source>
        <translation>ジョブを送信する前に内容を検査し、送信後に読み戻して比較します。</translation>
    </message>
    <message>
        <source>Transfers lists every file with its bytes and state. Retry failed sends none that was finished.</source>
        <translation>「転送」は、すべてのファイルをバイト数と状態とともに表示します。「失敗分を再試行」は、完了したファイルを送信しません。</translation>
    </message>
    <message>
        <source>Backups of this controller, the newest first, with the files that are missing in each. ▲ marks one that is not whole.</source>
        <translation>このコントローラのバックアップを新しい順に、それぞれに足りないファイルとともに表示します。▲は完全でないバックアップを示します。</translation>
    </message>
    <message>
        <source>Back up now reads every file into a new folder with a checksum of each. A file that fails does not stop the rest.</source>
        <translation>「今すぐバックアップ」は、すべてのファイルを新しいフォルダに読み出し、それぞれにチェックサムを付けます。失敗したファイルがあっても、残りは続けます。</translation>
    </message>
    <message>
        <source>Verify reads every byte again. Compare finds what differs from another backup or from the controller now; dates and counters are left out, and the page says which.</source>
        <translation>「検証」は、全バイトを読み直します。「比較」は、別のバックアップまたはコントローラの現在の内容との違いを調べます。日付とカウンタは除き、何を除いたかをページに表示します。</translation>
    </message>
    <message>
        <source>Restore… plans first, makes a fresh backup, sends what changed, and reads it back. It needs an engineer and REMOTE, and no job may run.</source>
        <translation>「復元…」は、先に計画を立て、新しいバックアップを作成し、変わったものを送信し、読み戻します。レベル「技術者」とREMOTEが必要で、ジョブの運転中は行えません。</translation>
    </message>
    <message>
        <source>Old backups go by number and age as set below the list, never the last good one or a pinned one.</source>
        <translation>古いバックアップは、一覧の下で設定した個数と期間に従って削除します。最後の良好なバックアップと固定したバックアップは削除しません。</translation>
    </message>
    <message>
        <source>Everything that was tried from here: writes, starts, moves, servo, files, and what was refused or withheld, with user, old and new value, and the controller&apos;s answer.</source>
        <translation>ここから試みたすべてのこと (書込み、起動、移動、サーボ、ファイル、および拒否されたものと送信しなかったもの) を、ユーザ、現在の値と新しい値、コントローラの応答とともに表示します。</translation>
    </message>
    <message>
        <source>“Unknown” means that no answer came: it may have happened.</source>
        <translation>「不明」は、応答がなかったことを示します。実行された可能性があります。</translation>
    </message>
    <message>
        <source>Filter by controller, kind, time and outcome, or search in all texts. Older records come when scrolling down.</source>
        <translation>コントローラ、内容、時刻、結果で絞り込むか、すべての文字列を検索します。下へスクロールすると古い記録を表示します。</translation>
    </message>
    <message>
        <source>The journal is kept on this computer for all controllers and can be read without a connection. Export writes what the filter shows.</source>
        <translation>操作履歴は、すべてのコントローラについてこのコンピュータに保存し、接続していなくても読めます。「エクスポート」は、絞り込みで表示しているものを書き出します。</translation>
    </message>
    <message>
        <source>Go to a signal</source>
        <translation>信号へジャンプ</translation>
    </message>
    <message>
        <source>Write the signal (network inputs)</source>
        <translation>信号の書込み (ネットワーク入力)</translation>
    </message>
    <message>
        <source>On the tab Watch: watch the signal no longer</source>
        <translation>「ウォッチ」タブで: 信号のウォッチをやめる</translation>
    </message>
    <message>
        <source>Go to a register</source>
        <translation>レジスタへジャンプ</translation>
    </message>
    <message>
        <source>Open the editor; in it: stage the value</source>
        <translation>入力欄を開く。入力欄で: 値を書込み予定に追加</translation>
    </message>
    <message>
        <source>Discard the staged value</source>
        <translation>書込み予定の値を破棄</translation>
    </message>
    <message>
        <source>Copy the chosen rows</source>
        <translation>選んだ行をコピー</translation>
    </message>
    <message>
        <source>Paste cells: they are staged after a preview</source>
        <translation>セルを貼付け: プレビューの後で書込み予定に追加</translation>
    </message>
    <message>
        <source>Go to a variable</source>
        <translation>変数へジャンプ</translation>
    </message>
    <message>
        <source>Held on a jog button: steps, if keyboard jog was switched on</source>
        <translation>ジョグボタンの上で押し続ける: ステップを実行 (キーボードでのジョグがオンの場合)</translation>
    </message>
    <message>
        <source>In the sheet of the move, after typing its words: move</source>
        <translation>移動の画面で、指定の語を入力した後: 移動</translation>
    </message>
    <message>
        <source>In the plot: move the cursor</source>
        <translation>プロットで: カーソルを動かす</translation>
    </message>
    <message>
        <source>In the plot: cursor to the oldest or newest time in view</source>
        <translation>プロットで: カーソルを表示範囲の最も古い時刻または最も新しい時刻へ移す</translation>
    </message>
    <message>
        <source>In the plot: take the cursor away</source>
        <translation>プロットで: カーソルを消す</translation>
    </message>
    <message>
        <source>In the list of signals: remove it from the trend</source>
        <translation>信号の一覧で: トレンドから外す</translation>
    </message>
    <message>
        <source>In the start sheet, after typing its words: start</source>
        <translation>起動の画面で、指定の語を入力した後: 起動</translation>
    </message>
    <message>
        <source>Copy the chosen rows of the list with the focus</source>
        <translation>フォーカスのある一覧で選んだ行をコピー</translation>
    </message>
    <message>
        <source>“Job” is what the controller names: at rest the job that a start would begin, else the one that runs. “Run” says which.</source>
        <translation>「ジョブ」はコントローラが知らせるジョブです。停止中は起動したときに始まるジョブ、それ以外は運転中のジョブです。どちらかは「運転」で分かります。</translation>
    </message>
    <message>
        <source>All controllers side by side: those in alarm first, then those without a link and those that are held, then the others in a fixed order.</source>
        <translation>すべてのコントローラを並べて表示します。アラーム中のもの、リンクがないものとホールド中のもの、その他の順で、その他の並びは固定です。</translation>
    </message>
    <message>
        <source>A click opens a controller’s pages. The others stay connected and are read once a second.</source>
        <translation>クリックすると、そのコントローラのページを開きます。ほかのコントローラも接続したままで、毎秒1回読み出します。</translation>
    </message>
    <message>
        <source>HOLD ALL orders a software hold at every controller that is not off, asks nothing, and says of each whether it was confirmed. It is no emergency stop.</source>
        <translation>「全台HOLD」は、オフではないすべてのコントローラにソフトウェアホールドを指令します。確認の問いは出さず、確認できたかどうかをコントローラごとに示します。非常停止ではありません。</translation>
    </message>
    <message>
        <source>Connect all and Back up all only read. Nothing else goes to several controllers at once.</source>
        <translation>「全台接続」と「全台バックアップ」は読出しだけを行います。これ以外に、複数のコントローラへ同時に送るものはありません。</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>フリート</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>カンマ区切り (*.csv)</translation>
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
        <translation>信号グループとB変数を要求しました: %1。</translation>
    </message>
    <message>
        <source>A signal group and a B variable are asked for while this sheet is open. Writing needs no REMOTE; whether data are protected cannot be read.</source>
        <translation>この画面を開いている間、信号グループとB変数を要求します。書込みにREMOTEは不要です。データが保護されているかどうかは読み出せません。</translation>
    </message>
    <message>
        <source>The software version, which tells the model, was not read yet.</source>
        <translation>機種を示すソフトウェアバージョンをまだ読み出していません。</translation>
    </message>
    <message>
        <source>The profile says %1, but %2 is the software of a %3.</source>
        <translation>プロファイルでは%1ですが、%2は%3のソフトウェアです。</translation>
    </message>
    <message>
        <source>The software %1 does not tell the model. The ranges are those of the profile&apos;s %2.</source>
        <translation>ソフトウェア%1からは機種が分かりません。範囲はプロファイルの%2のものです。</translation>
    </message>
    <message>
        <source>The software %1 is that of a %2. Its ranges come from a table, not from the controller.</source>
        <translation>ソフトウェア%1は%2のものです。範囲は表によるもので、コントローラから読み出したものではありません。</translation>
    </message>
    <message>
        <source>The last HOLD was refused: %1.</source>
        <translation>最後のHOLDは拒否されました: %1。</translation>
    </message>
    <message>
        <source>The last HOLD was confirmed by the status. It is a software hold, no emergency stop.</source>
        <translation>最後のHOLDは状態で確認しました。これはソフトウェアホールドであり、非常停止ではありません。</translation>
    </message>
    <message>
        <source>The last HOLD was sent, and the status did not confirm it.</source>
        <translation>最後のHOLDを送信しましたが、状態では確認できませんでした。</translation>
    </message>
    <message>
        <source>It needs neither REMOTE nor an access level, and was not tried. It is a software hold, no emergency stop.</source>
        <translation>REMOTEもアクセスレベルも不要です。まだ試していません。これはソフトウェアホールドであり、非常停止ではありません。</translation>
    </message>
    <message>
        <source>A list of jobs was asked for at port %1: %2.</source>
        <translation>ポート%1にジョブの一覧を要求しました: %2。</translation>
    </message>
    <message>
        <source>A list of jobs is asked for at port %1.</source>
        <translation>ポート%1にジョブの一覧を要求します。</translation>
    </message>
    <message>
        <source>Port %1 lists the jobs. Sending and deleting files need REMOTE.</source>
        <translation>ポート%1がジョブの一覧を応答しています。ファイルの送信と削除にはREMOTEが必要です。</translation>
    </message>
    <message>
        <source>This simulation has B000 at number %1 on the network.</source>
        <translation>このシミュレーションでは、ネットワーク上の番号%1がB000です。</translation>
    </message>
    <message>
        <source>The software version, with which it was compared, was not read yet.</source>
        <translation>比較時のソフトウェアと照らし合わせるソフトウェアバージョンを、まだ読み出していません。</translation>
    </message>
    <message>
        <source>It was compared with software %1, but %2 runs now: variables are not written before it is compared again.</source>
        <translation>ソフトウェア%1で比較しましたが、現在は%2です。もう一度比較するまで、変数は書き込みません。</translation>
    </message>
    <message>
        <source>Whether B000 is number 0 or 1 on the network is unverified; variables are not written.</source>
        <translation>B000がネットワーク上で番号0か番号1かは未照合です。変数は書き込みません。</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1: number 0 on the network is B000.</source>
        <translation>%1にペンダントと比較済み: ネットワーク上の番号0がB000です。</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1, shifted: number 1 on the network is B000.</source>
        <translation>%1にペンダントと比較済み、ずれあり: ネットワーク上の番号1がB000です。</translation>
    </message>
    <message>
        <source>The controller does not answer any more. Reading resumes by itself.</source>
        <translation>コントローラが応答しなくなりました。読出しは自動で再開します。</translation>
    </message>
    <message>
        <source>The controller tells its status and system information. Reading needs no REMOTE.</source>
        <translation>コントローラは状態とシステム情報を知らせています。読出しにREMOTEは不要です。</translation>
    </message>
    <message>
        <source>Orders are taken in command remote alone: start, select, reset, cycle, servo on.</source>
        <translation>次の指令は、コマンドリモートのときだけ受け付けられます: 起動、選択、リセット、サイクル、サーボオン。</translation>
    </message>
    <message>
        <source>It needs REMOTE, and that no job runs.</source>
        <translation>REMOTEが必要です。また、運転中のジョブがないことが必要です。</translation>
    </message>
    <message>
        <source>It needs PLAY, REMOTE, servo on and a job, and nothing that holds the robot.</source>
        <translation>PLAY、REMOTE、サーボオン、ジョブが必要です。また、ロボットがホールドされていないことが必要です。</translation>
    </message>
    <message>
        <source>It needs PLAY and REMOTE. Servo off can always be ordered from here; whether it is taken without REMOTE is up to the controller.</source>
        <translation>PLAYとREMOTEが必要です。サーボオフはいつでもここから指令できます。REMOTEでないときに受け付けるかどうかは、コントローラによります。</translation>
    </message>
    <message>
        <source>They need what a start needs, but for the job, and a model that knows them.</source>
        <translation>ジョブを除いて起動と同じ条件が必要です。また、これらの指令に対応する機種であることが必要です。</translation>
    </message>
    <message>
        <source>Sending a file that exists there needs REMOTE and two parameters.</source>
        <translation>コントローラにすでにあるファイルを送信するには、REMOTEと2つのパラメータの設定が必要です。</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>読出し</translation>
    </message>
    <message>
        <source>I/O and variables</source>
        <translation>I/Oと変数</translation>
    </message>
    <message>
        <source>Ranges of the model</source>
        <translation>機種の範囲</translation>
    </message>
    <message>
        <source>Orders (REMOTE)</source>
        <translation>指令 (REMOTE)</translation>
    </message>
    <message>
        <source>Selecting a job</source>
        <translation>ジョブの選択</translation>
    </message>
    <message>
        <source>Starting a job</source>
        <translation>ジョブの起動</translation>
    </message>
    <message>
        <source>Switching servo on</source>
        <translation>サーボをオンにする</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>ジョグと移動</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (ソフトウェア)</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Replacing files</source>
        <translation>ファイルの置換え</translation>
    </message>
    <message>
        <source>Numbering of variables</source>
        <translation>変数番号の方式</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>可</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>不可</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>実測</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>推定</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>読出し不可</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>未読出し</translation>
    </message>
    <message>
        <source>In the way: %1.</source>
        <translation>妨げている条件: %1。</translation>
    </message>
    <message>
        <source>HSES does not tell whether this is so: %1.</source>
        <translation>HSESでは、次のとおりかどうかが分かりません: %1。</translation>
    </message>
    <message>
        <source>What helps: %1.</source>
        <translation>対処: %1。</translation>
    </message>
    <message>
        <source>Diagnose… in the rail finds out at which step it fails.</source>
        <translation>サイドバーの「診断…」で、どの段階で不合格になるかが分かります。</translation>
    </message>
    <message>
        <source>Correct the model in the profile (Connect…).</source>
        <translation>プロファイルの機種を修正してください (「接続…」)。</translation>
    </message>
    <message>
        <source>Use the pendant.</source>
        <translation>ペンダントを使ってください。</translation>
    </message>
    <message>
        <source>Pendesk %1, readiness of %2 (%3), %4, %5</source>
        <translation>Pendesk %1、%2の準備状態 (%3)、%4、%5</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>subject, allowance, evidence</comment>
        <translation>%1: %2、%3</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>この行には、必要な数値がそろっていません。</translation>
    </message>
</context>
<context>
    <name>Shown</name>
    <message>
        <source>Not read yet.</source>
        <translation>まだ読み出していません。</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>拒否: %1</translation>
    </message>
    <message>
        <source>Last seen %1</source>
        <translation>最終確認 %1</translation>
    </message>
    <message>
        <source>not taught</source>
        <translation>未教示</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>HELD</source>
        <translation>ホールド中</translation>
    </message>
    <message>
        <source>no</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>PENDANT</source>
        <translation>ペンダント</translation>
    </message>
    <message>
        <source>EXTERNAL</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>コマンド</translation>
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
        <translation>モードなし</translation>
    </message>
    <message>
        <source>REMOTE %1</source>
        <translation>REMOTE %1</translation>
    </message>
    <message>
        <source>STEP</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>1 CYCLE</source>
        <translation>1サイクル</translation>
    </message>
    <message>
        <source>CONTINUOUS</source>
        <translation>連続</translation>
    </message>
    <message>
        <source>NO CYCLE</source>
        <translation>サイクルなし</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>運転中</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>停止中</translation>
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
        <translation>なし</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>ALARM</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>held</source>
        <translation>ホールド中</translation>
    </message>
    <message>
        <source>contradictory</source>
        <translation>矛盾</translation>
    </message>
    <message>
        <source>running</source>
        <translation>運転中</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>line %1 · step %2 · %3</source>
        <translation>行 %1 · ステップ %2 · %3</translation>
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
        <translation>パルス</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>HOLD asked for, %1 s…</source>
        <translation>HOLDを要求中、%1 秒…</translation>
    </message>
    <message>
        <source>held by command</source>
        <translation>コマンドによるホールド中</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>ペンダントによるホールド中</translation>
    </message>
    <message>
        <source>held externally</source>
        <translation>外部ホールド中</translation>
    </message>
    <message>
        <source>HOLD refused</source>
        <translation>HOLD拒否</translation>
    </message>
    <message>
        <source>HOLD not confirmed</source>
        <translation>HOLD未確認</translation>
    </message>
    <message>
        <source>released</source>
        <translation>解除済み</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>ソフトウェアホールド · Pauseキー</translation>
    </message>
</context>
<context>
    <name>cell::Sentences</name>
    <message>
        <source>%1 changed</source>
        <translation>%1が変更</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>%1: gone.</source>
        <translation>%1: なくなりました。</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) differ, from line %1 on.</source>
        <translation>
            <numerusform>%1行目から、%n行が異なります。</numerusform>
        </translation>
    </message>
    <message>
        <source>The newer file is empty; what stood in it is not known to be deleted.</source>
        <translation>新しい方のファイルが空です。元の内容が削除されたかどうかは不明です。</translation>
    </message>
    <message>
        <source>The older file is empty.</source>
        <translation>古い方のファイルが空です。</translation>
    </message>
    <message numerus="yes">
        <source>And %n more difference(s).</source>
        <translation>
            <numerusform>ほかに%n件の違いがあります。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes; the content differs.</source>
        <translation>%1バイト。内容が異なります。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>moved %1 mm (%2)</source>
        <translation>%1 mm移動 (%2)</translation>
    </message>
    <message>
        <source>turned %1 deg (%2)</source>
        <translation>%1度回転 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>Used by %n job(s).</source>
        <translation>
            <numerusform>%n個のジョブで使用しています。</numerusform>
        </translation>
    </message>
    <message>
        <source>could not be read in one of the files</source>
        <translation>一方のファイルで読み取れませんでした</translation>
    </message>
    <message>
        <source>name %1</source>
        <translation>名称 %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>weight %1 kg</source>
        <translation>重量 %1 kg</translation>
    </message>
    <message>
        <source>centre of gravity %1 mm</source>
        <translation>重心 %1 mm</translation>
    </message>
    <message>
        <source>inertia %1 kgm²</source>
        <translation>慣性モーメント %1 kgm²</translation>
    </message>
    <message>
        <source>kind of entry %1</source>
        <translation>入力の種類 %1</translation>
    </message>
    <message>
        <source>%1 is new.</source>
        <translation>%1は新規です。</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1はなくなりました。</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>ツール%1</translation>
    </message>
    <message>
        <source>User frame %1</source>
        <translation>ユーザ座標%1</translation>
    </message>
    <message>
        <source>where it lies could not be read in one of the files</source>
        <translation>一方のファイルで、その位置を読み取れませんでした</translation>
    </message>
    <message>
        <source>taught with tool %1</source>
        <translation>ツール%1で教示</translation>
    </message>
    <message>
        <source>taught at other points</source>
        <translation>別の点で教示</translation>
    </message>
    <message>
        <source>Area %1</source>
        <translation>領域%1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>設定あり</translation>
    </message>
    <message>
        <source>no longer set</source>
        <translation>設定なしに変更</translation>
    </message>
    <message>
        <source>upper %1 %2 mm</source>
        <translation>上限 %1 %2 mm</translation>
    </message>
    <message>
        <source>lower %1 %2 mm</source>
        <translation>下限 %1 %2 mm</translation>
    </message>
    <message>
        <source>other coordinates or another group</source>
        <translation>別の座標または別のグループ</translation>
    </message>
    <message>
        <source>Collision detection, set %1, group %2</source>
        <translation>衝突検出、条件%1、グループ%2</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>オフに変更</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>オンに変更</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>レベル %1</translation>
    </message>
    <message>
        <source>robot %1 limit %2 %3 %4 deg</source>
        <translation>ロボット%1 リミット%2 %3 %4度</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>変更あり</translation>
    </message>
    <message>
        <source>meaning not known</source>
        <translation>意味は不明</translation>
    </message>
    <message>
        <source>Section %1 has %2 values.</source>
        <translation>セクション%1の値は%2個です。</translation>
    </message>
    <message>
        <source>System part</source>
        <translation>システム部</translation>
    </message>
    <message>
        <source>User part</source>
        <translation>ユーザ部</translation>
    </message>
    <message>
        <source>decides %1</source>
        <translation>%1を決定</translation>
    </message>
    <message>
        <source>%1, instruction %2: %3</source>
        <translation>%1、命令%2: %3</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>%1が%2に変更</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1は新規</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1は削除</translation>
    </message>
    <message>
        <source>Now also written: %1.</source>
        <translation>新たに書き込むもの: %1。</translation>
    </message>
    <message>
        <source>No longer written: %1.</source>
        <translation>書き込まなくなったもの: %1。</translation>
    </message>
    <message>
        <source>The control group %1 is another one.</source>
        <translation>制御グループ%1が別のものになっています。</translation>
    </message>
    <message>
        <source>Another number of control groups.</source>
        <translation>制御グループの数が異なります。</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1時間 %2分</translation>
    </message>
    <message>
        <source>The hours of control power went back by %1: another controller, or its memory was cleared.</source>
        <translation>制御電源の通電時間が%1戻りました。別のコントローラか、メモリが消去されています。</translation>
    </message>
    <message>
        <source>%1 powered in between.</source>
        <translation>その間の通電は%1です。</translation>
    </message>
    <message>
        <source>Section %1 is new.</source>
        <translation>セクション%1は新規です。</translation>
    </message>
    <message>
        <source>Section %1 is not in the newer file.</source>
        <translation>セクション%1が新しい方のファイルにありません。</translation>
    </message>
    <message>
        <source>Presets of timers and counters changed.</source>
        <translation>タイマとカウンタの設定値が変更されました。</translation>
    </message>
    <message>
        <source>Home position of %1 axis %2 recalibrated (%3): taught points may be off.</source>
        <translation>%1 軸%2の原点位置が再設定されました (%3)。教示点がずれているおそれがあります。</translation>
    </message>
    <message>
        <source>Position of %1 axis %2: %3 pulses.</source>
        <translation>%1 軸%2の位置: %3パルス。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source> Command remote select: HSES control is permitted.</source>
        <translation> CMD REMOTE SEL: HSESによる制御が許可されます。</translation>
    </message>
    <message>
        <source> Command remote select: HSES control will be refused.</source>
        <translation> CMD REMOTE SEL: HSESによる制御は拒否されます。</translation>
    </message>
    <message>
        <source>Pseudo input %1 switched %2.</source>
        <translation>疑似入力%1が%2に切り替わりました。</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>ソフトウェア</translation>
    </message>
    <message>
        <source>Parameter version</source>
        <translation>パラメータバージョン</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>基板</translation>
    </message>
    <message numerus="yes">
        <source>%n new entry(ies).</source>
        <translation>
            <numerusform>新しい記録が%n件あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>The log rolled over: edits in between are not known.</source>
        <translation>ログが一巡しました。その間の編集は不明です。</translation>
    </message>
    <message numerus="yes">
        <source>%n new alarm(s): %1.</source>
        <translation>
            <numerusform>新しいアラームが%n件あります: %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>coordinates %1</source>
        <translation>座標 %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>ツール %1</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>ユーザ座標 %1</translation>
    </message>
    <message>
        <source>form of the arm</source>
        <translation>アームの形態</translation>
    </message>
    <message>
        <source>now set (%1)</source>
        <translation>設定ありに変更 (%1)</translation>
    </message>
    <message>
        <source>Number of variables %1</source>
        <translation>変数の数 %1</translation>
    </message>
    <message>
        <source>%1 lost its name “%2”.</source>
        <translation>%1の名称「%2」がなくなりました。</translation>
    </message>
    <message>
        <source>%1 is now named “%2”.</source>
        <translation>%1の名称が「%2」になりました。</translation>
    </message>
    <message>
        <source>%1 “%2” is now named “%3”.</source>
        <translation>%1「%2」の名称が「%3」になりました。</translation>
    </message>
    <message>
        <source>written</source>
        <translation>書込み</translation>
    </message>
    <message>
        <source>read</source>
        <translation>読出し</translation>
    </message>
    <message>
        <source>waited for</source>
        <translation>待ち</translation>
    </message>
    <message>
        <source>called</source>
        <translation>呼出し</translation>
    </message>
    <message>
        <source>jumped to</source>
        <translation>ジャンプ先</translation>
    </message>
    <message>
        <source>started</source>
        <translation>起動</translation>
    </message>
    <message>
        <source>named</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>may be %1</source>
        <translation>%1の可能性</translation>
    </message>
    <message>
        <source>%1 line %2</source>
        <translation>%1 %2行</translation>
    </message>
    <message>
        <source>%1 is called, and no file has it: %2.</source>
        <translation>%1 は呼び出されていますが、どのファイルにもありません: %2</translation>
    </message>
    <message>
        <source>%1 is written in several places: %2.</source>
        <translation>%1 は複数の箇所で書き込まれます: %2</translation>
    </message>
    <message>
        <source>%1 is read and never written in the files: %2.</source>
        <translation>%1 は読み出されますが、ファイル内では書き込まれません: %2</translation>
    </message>
    <message>
        <source>%1 has several names: %2.</source>
        <translation>%1 には複数の名称があります: %2</translation>
    </message>
    <message>
        <source>%1 is used and its data were not entered: %2.</source>
        <translation>%1 は使用されていますが、データが未入力です: %2</translation>
    </message>
    <message>
        <source>%1 is named by no other job and no macro.</source>
        <translation>%1 は他のジョブやマクロから参照されていません。</translation>
    </message>
</context>
<context>
    <name>cellfiles::Sentences</name>
    <message>
        <source>values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>block</source>
        <translation>ブロック</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>collision detection</source>
        <translation>衝突検出</translation>
    </message>
    <message>
        <source>set</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>group</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>reasons of stops</source>
        <translation>停止要因</translation>
    </message>
    <message>
        <source>number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日付</translation>
    </message>
    <message>
        <source>reasons</source>
        <translation>要因</translation>
    </message>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>この行には、必要な数値がそろっていません。</translation>
    </message>
    <message>
        <source>The block has no number.</source>
        <translation>ブロックに番号がありません。</translation>
    </message>
    <message>
        <source>Tool %1 is not complete.</source>
        <translation>ツール%1のデータが完全ではありません。</translation>
    </message>
    <message>
        <source>User frame %1 is not complete: where it lies is unknown.</source>
        <translation>ユーザ座標%1のデータが完全ではありません。その位置は不明です。</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>User frames</source>
        <translation>ユーザ座標</translation>
    </message>
    <message>
        <source>Interference areas</source>
        <translation>干渉領域</translation>
    </message>
    <message>
        <source>Collision detection</source>
        <translation>衝突検出</translation>
    </message>
    <message>
        <source>Weaving conditions</source>
        <translation>ウィービング条件</translation>
    </message>
    <message>
        <source>Arc start conditions</source>
        <translation>アーク開始条件</translation>
    </message>
    <message>
        <source>Arc end conditions</source>
        <translation>アーク終了条件</translation>
    </message>
    <message>
        <source>Arc auxiliary conditions</source>
        <translation>アーク補助条件</translation>
    </message>
    <message>
        <source>Welders</source>
        <translation>溶接機</translation>
    </message>
    <message>
        <source>Cutting shapes</source>
        <translation>切断形状</translation>
    </message>
    <message>
        <source>Maintenance conditions</source>
        <translation>保守条件</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Names of variables</source>
        <translation>変数の名称</translation>
    </message>
    <message>
        <source>Names of signals</source>
        <translation>信号の名称</translation>
    </message>
    <message>
        <source>Names of external signals</source>
        <translation>外部信号の名称</translation>
    </message>
    <message>
        <source>Names of registers</source>
        <translation>レジスタの名称</translation>
    </message>
    <message>
        <source>Names of timers</source>
        <translation>タイマの名称</translation>
    </message>
    <message>
        <source>Timers</source>
        <translation>タイマ</translation>
    </message>
    <message>
        <source>Timer settings</source>
        <translation>タイマの設定</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>ウォッチリスト</translation>
    </message>
    <message>
        <source>Groups of signals</source>
        <translation>信号グループ</translation>
    </message>
    <message>
        <source>User words</source>
        <translation>ユーザ登録語</translation>
    </message>
    <message>
        <source>User menus</source>
        <translation>ユーザメニュー</translation>
    </message>
    <message>
        <source>Names of flags</source>
        <translation>フラグの名称</translation>
    </message>
    <message>
        <source>Key functions</source>
        <translation>キー割付け</translation>
    </message>
    <message>
        <source>Interface panels</source>
        <translation>インタフェースパネル</translation>
    </message>
    <message>
        <source>Macro commands</source>
        <translation>マクロ命令</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>ラダー</translation>
    </message>
    <message>
        <source>Pseudo inputs</source>
        <translation>疑似入力</translation>
    </message>
    <message>
        <source>I/O boards</source>
        <translation>I/O基板</translation>
    </message>
    <message>
        <source>I/O axes</source>
        <translation>I/O軸</translation>
    </message>
    <message>
        <source>EtherNet/IP</source>
        <translation>EtherNet/IP</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>ネットワーク</translation>
    </message>
    <message>
        <source>Address translation</source>
        <translation>アドレス変換</translation>
    </message>
    <message>
        <source>Remote users</source>
        <translation>リモートユーザ</translation>
    </message>
    <message>
        <source>Home positions of the encoders</source>
        <translation>エンコーダの原点位置</translation>
    </message>
    <message>
        <source>Second home position</source>
        <translation>第2原点位置</translation>
    </message>
    <message>
        <source>Operation origin</source>
        <translation>作業原点</translation>
    </message>
    <message>
        <source>Robot calibration</source>
        <translation>ロボットキャリブレーション</translation>
    </message>
    <message>
        <source>Tool interference</source>
        <translation>ツール干渉</translation>
    </message>
    <message>
        <source>Arrangement of robots</source>
        <translation>ロボットの配置</translation>
    </message>
    <message>
        <source>Approach buzzer</source>
        <translation>接近ブザー</translation>
    </message>
    <message>
        <source>Servo assistance</source>
        <translation>サーボ支援</translation>
    </message>
    <message>
        <source>Safety logic</source>
        <translation>安全ロジック</translation>
    </message>
    <message>
        <source>Range limits</source>
        <translation>動作範囲制限</translation>
    </message>
    <message>
        <source>Axis speed monitor</source>
        <translation>軸速度監視</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>速度制限</translation>
    </message>
    <message>
        <source>Tool angle monitor</source>
        <translation>ツール角度監視</translation>
    </message>
    <message>
        <source>Check sums of safety data</source>
        <translation>安全データのチェックサム</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>System</source>
        <translation>システム</translation>
    </message>
    <message>
        <source>System, options and change dates</source>
        <translation>システム、オプション、変更日</translation>
    </message>
    <message>
        <source>Operation log</source>
        <translation>操作ログ</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>アラーム履歴</translation>
    </message>
    <message>
        <source>Message history</source>
        <translation>メッセージ履歴</translation>
    </message>
    <message>
        <source>Fast events</source>
        <translation>高速イベント</translation>
    </message>
    <message>
        <source>Reasons of stops</source>
        <translation>停止要因</translation>
    </message>
    <message>
        <source>Maintenance counters</source>
        <translation>保守カウンタ</translation>
    </message>
    <message>
        <source>Torque counters</source>
        <translation>トルクカウンタ</translation>
    </message>
    <message>
        <source>Encoder heat</source>
        <translation>エンコーダ温度</translation>
    </message>
    <message>
        <source>Step diagnosis</source>
        <translation>ステップ診断</translation>
    </message>
    <message>
        <source>Job monitor</source>
        <translation>ジョブモニタ</translation>
    </message>
    <message>
        <source>Robot monitor</source>
        <translation>ロボットモニタ</translation>
    </message>
    <message>
        <source>Servo monitor</source>
        <translation>サーボモニタ</translation>
    </message>
    <message>
        <source>Regeneration unit</source>
        <translation>回生ユニット</translation>
    </message>
    <message>
        <source>Memory image</source>
        <translation>メモリイメージ</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Unknown file</source>
        <translation>不明なファイル</translation>
    </message>
    <message>
        <source>The file ends before the values of %1.</source>
        <translation>%1の値の前でファイルが終わっています。</translation>
    </message>
    <message>
        <source>The control groups of this line could not be read.</source>
        <translation>この行の制御グループを読み取れませんでした。</translation>
    </message>
    <message>
        <source>This section is not understood.</source>
        <translation>このセクションは解釈できません。</translation>
    </message>
    <message>
        <source>“%1” is not understood.</source>
        <translation>「%1」は解釈できません。</translation>
    </message>
    <message>
        <source>The record in front of this date is not understood.</source>
        <translation>この日付の前のレコードは解釈できません。</translation>
    </message>
    <message>
        <source>The record that begins here is not complete.</source>
        <translation>ここから始まるレコードは完全ではありません。</translation>
    </message>
    <message>
        <source>The section %1 announces %2 records and holds %3.</source>
        <translation>セクション%1の通知レコード数は%2ですが、実際は%3です。</translation>
    </message>
    <message>
        <source>The entry is numbered %1 and is number %2 by its place.</source>
        <translation>項目の番号は%1ですが、並び順では%2番目です。</translation>
    </message>
    <message>
        <source>The entry is not complete.</source>
        <translation>項目が完全ではありません。</translation>
    </message>
    <message>
        <source>The number of the macro cannot be read.</source>
        <translation>マクロの番号を読み取れません。</translation>
    </message>
    <message>
        <source>The line holds NUL bytes.</source>
        <translation>この行にNULバイトがあります。</translation>
    </message>
    <message>
        <source>Lines end in LF alone. A pendant may take such a file for empty: convert it to CR LF before it is loaded.</source>
        <translation>行末がLFだけです。ペンダントがこのようなファイルを空とみなすことがあります。ロードする前にCR LFに変換してください。</translation>
    </message>
    <message>
        <source>The file ends within a line: it may be cut.</source>
        <translation>ファイルが行の途中で終わっています。途切れている可能性があります。</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>ファイルが空です。</translation>
    </message>
    <message>
        <source>The file is too long to be read.</source>
        <translation>ファイルが長すぎて読み取れません。</translation>
    </message>
    <message>
        <source>%1 has no section “%2”; the rows below it are not understood.</source>
        <translation>%1にセクション「%2」はありません。その下の行は解釈できません。</translation>
    </message>
    <message>
        <source>The row has %1 instead of 10 values; the missing ones of %2 are unknown.</source>
        <translation>この行の値は10個ではなく%1個です。%2の足りない値は不明です。</translation>
    </message>
    <message>
        <source>%1 is no number of 32 bits.</source>
        <translation>%1は32ビットの数値ではありません。</translation>
    </message>
    <message>
        <source>data transmission; 2 is over the network</source>
        <translation>データ伝送。2はネットワーク経由</translation>
    </message>
    <message>
        <source>numbering of variables for network clients; 1: by their number, 0: by their number plus one</source>
        <translation>ネットワーククライアントの変数番号の方式。1: その番号、0: 番号に1を加えた値</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files</source>
        <translation>1でネットワーククライアントによるファイルの上書きを許可</translation>
    </message>
    <message>
        <source>serial transmission: data bits, parity, stop, speed, timers</source>
        <translation>シリアル伝送: データビット、パリティ、ストップビット、速度、タイマ</translation>
    </message>
    <message>
        <source>3 permits overwriting when loading from USB</source>
        <translation>3でUSBからのロード時の上書きを許可</translation>
    </message>
    <message>
        <source>address and mask of the controller</source>
        <translation>コントローラのアドレスとマスク</translation>
    </message>
    <message>
        <source>1 permits FTP</source>
        <translation>1でFTPを許可</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files; the meaning of 2 is not known</source>
        <translation>1でネットワーククライアントによるファイルの上書きを許可。2の意味は不明</translation>
    </message>
    <message>
        <source>addresses and masks</source>
        <translation>アドレスとマスク</translation>
    </message>
    <message>
        <source>0 permits selecting jobs in remote and play</source>
        <translation>0でリモートとプレイでのジョブ選択を許可</translation>
    </message>
    <message>
        <source>pendant operation in remote; 63 permits starts and edits</source>
        <translation>リモート時のペンダント操作。63で起動と編集を許可</translation>
    </message>
    <message>
        <source>alias function; 0 permits loading own names</source>
        <translation>別名機能。0で独自の名称のロードを許可</translation>
    </message>
    <message>
        <source>drivers that start motion need 0</source>
        <translation>動作を起動するドライバには0が必要</translation>
    </message>
    <message>
        <source>MotoPlus and telnet settings</source>
        <translation>MotoPlusとtelnetの設定</translation>
    </message>
    <message>
        <source>number of variables of each kind</source>
        <translation>種類ごとの変数の数</translation>
    </message>
    <message>
        <source>control groups and their axes</source>
        <translation>制御グループとその軸</translation>
    </message>
    <message>
        <source>pseudo input signals</source>
        <translation>疑似入力信号</translation>
    </message>
    <message>
        <source>The name “%1” holds bytes that the text encoding does not know.</source>
        <translation>名称「%1」に、この文字コードにないバイトがあります。</translation>
    </message>
    <message>
        <source>The row has more than four names.</source>
        <translation>この行の名称が4つを超えています。</translation>
    </message>
    <message>
        <source>There are more names than signals.</source>
        <translation>名称が信号より多いです。</translation>
    </message>
    <message>
        <source>The row is not a number, two flags and a name.</source>
        <translation>この行は「番号、2つのフラグ、名称」の形ではありません。</translation>
    </message>
    <message numerus="yes">
        <source>%1 is beyond the %n variable(s) that the file announces.</source>
        <translation>
            <numerusform>%1は、ファイルが通知する%n個の変数の範囲を超えています。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was named “%2” before; which name the pendant shows is not known.</source>
        <translation>%1の名称は前に「%2」でした。ペンダントがどちらの名称を表示するかは不明です。</translation>
    </message>
    <message>
        <source>The line stands in a section that names no signals.</source>
        <translation>この行は、信号の名称ではないセクションにあります。</translation>
    </message>
    <message>
        <source>The line does not announce a number for each of the eight kinds.</source>
        <translation>この行には、8種類それぞれの数がそろっていません。</translation>
    </message>
    <message>
        <source>The hours could not be read.</source>
        <translation>時間を読み取れませんでした。</translation>
    </message>
    <message>
        <source>The file does not say the version of the system software.</source>
        <translation>ファイルにシステムソフトウェアのバージョンがありません。</translation>
    </message>
    <message>
        <source>system</source>
        <translation>システム</translation>
    </message>
    <message>
        <source>model</source>
        <translation>機種</translation>
    </message>
    <message>
        <source>software</source>
        <translation>ソフトウェア</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>application</source>
        <translation>用途</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n axis/axes</source>
        <translation>
            <numerusform>%1、%n軸</numerusform>
        </translation>
    </message>
    <message>
        <source>boards</source>
        <translation>基板</translation>
    </message>
    <message>
        <source>board</source>
        <translation>基板</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>counter</source>
        <translation>カウンタ</translation>
    </message>
    <message>
        <source>options</source>
        <translation>オプション</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>意味</translation>
    </message>
    <message>
        <source>ladder</source>
        <translation>ラダー</translation>
    </message>
    <message>
        <source>part</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>instruction</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>operation log</source>
        <translation>操作ログ</translation>
    </message>
    <message>
        <source>event</source>
        <translation>イベント</translation>
    </message>
    <message>
        <source>alarm history</source>
        <translation>アラーム履歴</translation>
    </message>
    <message>
        <source>class</source>
        <translation>区分</translation>
    </message>
    <message>
        <source>code</source>
        <translation>コード</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>未入力</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手入力</translation>
    </message>
    <message>
        <source>measured load</source>
        <translation>負荷の測定値</translation>
    </message>
    <message>
        <source>base coordinates</source>
        <translation>ベース座標</translation>
    </message>
    <message>
        <source>robot coordinates</source>
        <translation>ロボット座標</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>ユーザ座標%1</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>未使用</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>weight kg</source>
        <translation>重量 kg</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>入力方法</translation>
    </message>
    <message>
        <source>user frames</source>
        <translation>ユーザ座標</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>interference areas</source>
        <translation>干渉領域</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>座標</translation>
    </message>
    <message>
        <source>lower X mm</source>
        <translation>下限X mm</translation>
    </message>
    <message>
        <source>upper X mm</source>
        <translation>上限X mm</translation>
    </message>
    <message>
        <source>lower Y mm</source>
        <translation>下限Y mm</translation>
    </message>
    <message>
        <source>upper Y mm</source>
        <translation>上限Y mm</translation>
    </message>
    <message>
        <source>lower Z mm</source>
        <translation>下限Z mm</translation>
    </message>
    <message>
        <source>upper Z mm</source>
        <translation>上限Z mm</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>未設定</translation>
    </message>
    <message>
        <source>variables</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>ユーザ座標</translation>
    </message>
    <message>
        <source>form</source>
        <translation>形態</translation>
    </message>
    <message>
        <source>names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>register</source>
        <translation>レジスタ</translation>
    </message>
    <message>
        <source>timer</source>
        <translation>タイマ</translation>
    </message>
    <message>
        <source>home positions, pulses</source>
        <translation>原点位置、パルス</translation>
    </message>
    <message>
        <source>pseudo inputs</source>
        <translation>疑似入力</translation>
    </message>
    <message>
        <source>byte</source>
        <translation>バイト</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>ビット</translation>
    </message>
    <message>
        <source>The value of %1 could not be read.</source>
        <translation>%1の値を読み取れませんでした。</translation>
    </message>
    <message>
        <source>The file announces %1 variables %2 and has %3; the others are not known.</source>
        <translation>ファイルが通知する%2の変数は%1個ですが、実際は%3個です。残りは不明です。</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>tool coordinates</source>
        <translation>ツール座標</translation>
    </message>
    <message>
        <source>user coordinates</source>
        <translation>ユーザ座標</translation>
    </message>
    <message>
        <source>master tool coordinates</source>
        <translation>マスタツール座標</translation>
    </message>
</context>
<context>
    <name>dialogs::AccessSettingsDialog</name>
    <message>
        <source>Passcode and idle time</source>
        <translation>パスコードと無操作時間</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分</translation>
    </message>
    <message>
        <source>Back to Monitor after</source>
        <translation>「監視」に戻るまで</translation>
    </message>
    <message>
        <source>New passcode</source>
        <translation>新しいパスコード</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>もう一度入力</translation>
    </message>
    <message>
        <source>Leave both empty for no passcode.</source>
        <translation>パスコードを使わないときは、両方とも空にしてください。</translation>
    </message>
    <message>
        <source>The two are not the same.</source>
        <translation>2つの入力が一致しません。</translation>
    </message>
</context>
<context>
    <name>dialogs::AppearanceDialog</name>
    <message>
        <source>As the desktop</source>
        <translation>デスクトップの設定に従う</translation>
    </message>
    <message>
        <source>Language and look</source>
        <translation>言語と外観</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>L&amp;ook</source>
        <translation>外観(&amp;O)</translation>
    </message>
    <message>
        <source>Words of the robot and text from the controller stay as they are on the pendant.</source>
        <translation>ロボットの用語とコントローラからの文字列は、ペンダントの表示のままです。</translation>
    </message>
</context>
<context>
    <name>dialogs::ApplyDialog</name>
    <message>
        <source>Variable</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>現在の値</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新しい値</translation>
    </message>
    <message>
        <source>Apply — %1</source>
        <translation>適用 — %1</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>書き込む内容</translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s)</source>
        <translation>
            <numerusform>%n個の値を書込み</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s) to %1</source>
        <translation>
            <numerusform>%n個の値を%1に書込み</numerusform>
        </translation>
    </message>
    <message>
        <source>Each is written once and read back. What does not read back as it was written stays here and is marked.</source>
        <translation>それぞれ1回だけ書き込み、読み戻します。書き込んだとおりに読み戻せない値は、印を付けてここに残します。</translation>
    </message>
</context>
<context>
    <name>dialogs::CompareDialog</name>
    <message>
        <source>Both are the same, byte for byte.</source>
        <translation>両方は1バイトも違わず同じです。</translation>
    </message>
</context>
<context>
    <name>dialogs::ConnectionDialog</name>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Connect to a controller</source>
        <translation>コントローラに接続</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Known controllers</source>
        <translation>登録済みのコントローラ</translation>
    </message>
    <message>
        <source>CONTROLLERS</source>
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>Connecting only reads. HOLD: Pause key.</source>
        <translation>接続は読出しだけを行います。HOLD: Pauseキー。</translation>
    </message>
    <message>
        <source>There is another controller with the name “%1”.</source>
        <translation>「%1」という名前のコントローラがほかにあります。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>New controller</source>
        <translation>新しいコントローラ</translation>
    </message>
    <message>
        <source>A motion limit must be a number above 0, and each side of the box must begin before it ends.</source>
        <translation>動作の制限値は0より大きい数にし、許容範囲の各辺は下限を上限より小さくしてください。</translation>
    </message>
</context>
<context>
    <name>dialogs::DiagnosisDialog</name>
    <message>
        <source>Diagnosis — %1</source>
        <translation>診断 — %1</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>診断をコピー</translation>
    </message>
    <message>
        <source>The diagnosis is not finished yet.</source>
        <translation>診断はまだ終わっていません。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>It only reads. HOLD works meanwhile: Pause key.</source>
        <translation>診断は読出しだけを行います。その間もHOLDは有効です: Pauseキー。</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>コピーしました</translation>
    </message>
</context>
<context>
    <name>dialogs::HelpDialog</name>
    <message>
        <source>Help — %1</source>
        <translation>ヘルプ — %1</translation>
    </message>
    <message>
        <source>Search in this help</source>
        <translation>このヘルプを検索</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>この語句を含む項目はありません。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Keys of this page</source>
        <translation>このページのキー</translation>
    </message>
    <message>
        <source>Keys everywhere</source>
        <translation>共通のキー</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>Without a connection: connect to the controller on the filled button</source>
        <translation>未接続のとき: 塗りつぶしのボタンに示すコントローラに接続</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Live: read within its last three turns.</source>
        <translation>ライブ: 直近3回の読出し周期のうちに読み出した値です。</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>古い値</translation>
    </message>
    <message>
        <source>Stale: read once, too long ago. The tool tip says when. It is not what the robot does now.</source>
        <translation>古い値: 一度読み出しましたが、時間が経ちすぎています。時刻はツールチップに表示します。ロボットの今の状態ではありません。</translation>
    </message>
    <message>
        <source>Unknown: not read on this connection. It is never shown as 0.</source>
        <translation>不明: この接続では読み出していません。0と表示することはありません。</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>Refused: the controller does not tell it. The reason stands on the card or in the tool tip.</source>
        <translation>拒否: コントローラが知らせません。理由はカードまたはツールチップに表示します。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>A filled square: on, or 1.</source>
        <translation>塗りつぶしの四角: オン、または1です。</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>A hollow square: off, or 0.</source>
        <translation>中空の四角: オフ、または0です。</translation>
    </message>
    <message>
        <source>held</source>
        <translation>ホールド中</translation>
    </message>
    <message>
        <source>An amber triangle: error, hold, something not allowed or to be looked at.</source>
        <translation>橙色の三角: エラー、ホールド、許可されていないもの、または確認が必要なものです。</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>A red square: an alarm.</source>
        <translation>赤い四角: アラームです。</translation>
    </message>
    <message>
        <source>What the signs mean</source>
        <translation>記号の意味</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>見本</translation>
    </message>
    <message>
        <source>An amber ground in a table: typed and staged, not sent yet. A red one: it reads back differently from what was written.</source>
        <translation>表の橙色の背景: 入力して書込み予定に追加した値です。まだ送信していません。赤い背景: 書き込んだ値と異なる値が読み戻されました。</translation>
    </message>
</context>
<context>
    <name>dialogs::ImportDialog</name>
    <message>
        <source>Take over values — %1</source>
        <translation>値の取込み — %1</translation>
    </message>
    <message numerus="yes">
        <source>Stage %n value(s)</source>
        <translation>
            <numerusform>%n個の値を書込み予定に追加</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) would change</source>
        <translation>
            <numerusform>%n個の値が変わります</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are there already. Staging sends nothing to the controller.</source>
        <translation>
            <numerusform>%n個の値はすでに同じです。書込み予定に追加しても、コントローラには何も送信しません。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) cannot be read, so nothing is taken over:</source>
        <translation>
            <numerusform>%n行を読み取れないため、何も取り込みません:</numerusform>
        </translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>誤りの内容</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>現在の値</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新しい値</translation>
    </message>
    <message>
        <source>Lines that cannot be read</source>
        <translation>読み取れない行</translation>
    </message>
    <message>
        <source>Values that would change</source>
        <translation>変わる値</translation>
    </message>
</context>
<context>
    <name>dialogs::IoWriteDialog</name>
    <message>
        <source>Write %1 — %2</source>
        <translation>%1の書込み — %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>Will be</source>
        <translation>書込み後</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The eight signals #%1 to #%2 travel together: all of them are written as they stand here.</source>
        <translation>#%1から#%2までの8つの信号は一括で送信します。すべてここに表示したとおりに書き込みます。</translation>
    </message>
    <message>
        <source>The group is being read…</source>
        <translation>グループを読み出しています…</translation>
    </message>
    <message>
        <source>Written once, then read back.</source>
        <translation>1回だけ書き込み、読み戻します。</translation>
    </message>
    <message>
        <source>Another of the eight has changed meanwhile. Nothing was sent: look again.</source>
        <translation>その間に8つのうちほかの信号が変わりました。何も送信していません。もう一度確認してください。</translation>
    </message>
    <message>
        <source>Being written…</source>
        <translation>書き込んでいます…</translation>
    </message>
    <message>
        <source>Written, and read back as it was written.</source>
        <translation>書き込みました。書き込んだとおりに読み戻せました。</translation>
    </message>
    <message>
        <source>Accepted, but another value was read back: %1. Something else writes these signals.</source>
        <translation>受け付けられましたが、別の値が読み戻されました: %1。ほかの何かがこれらの信号を書き込んでいます。</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>オンにする</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>オフにする</translation>
    </message>
</context>
<context>
    <name>dialogs::JobEditor</name>
    <message>
        <source>Edit “%1”</source>
        <translation>「%1」を編集</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>ファイルの内容</translation>
    </message>
    <message>
        <source>Compare and send…</source>
        <translation>比較して送信…</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding lacks a character of this text.</source>
        <translation>このテキストに、コントローラの文字コードにない文字があります。</translation>
    </message>
</context>
<context>
    <name>dialogs::LadderView</name>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>未実施</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Pendesk %1, diagnosis of %2 (%3)</source>
        <translation>Pendesk %1、%2の診断 (%3)</translation>
    </message>
</context>
<context>
    <name>dialogs::MotionForm</name>
    <message>
        <source>The tool point must stay in this box (base frame, mm)</source>
        <translation>制御点をこの許容範囲の中に限る (ベース座標、mm)</translation>
    </message>
    <message>
        <source>User and tool frames were checked on this robot</source>
        <translation>ユーザ座標とツール座標をこのロボットで確認済み</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>速度、mm/s</translation>
    </message>
    <message>
        <source>Rotation speed, °/s</source>
        <translation>回転速度、°/s</translation>
    </message>
    <message>
        <source>Joint speed, %</source>
        <translation>関節速度、%</translation>
    </message>
    <message>
        <source>Jog step, mm</source>
        <translation>ジョグのステップ、mm</translation>
    </message>
    <message>
        <source>Jog step, °</source>
        <translation>ジョグのステップ、°</translation>
    </message>
    <message>
        <source>Jog step, pulses</source>
        <translation>ジョグのステップ、パルス</translation>
    </message>
    <message>
        <source>Descriptions disagree which code means the user and which the tool frame. Tick this only after a small move in both was watched at the robot.</source>
        <translation>どのコードがユーザ座標でどのコードがツール座標かは、資料によって異なります。両方の座標での小さな移動をロボットのそばで見て確認した後にだけ、チェックを付けてください。</translation>
    </message>
    <message>
        <source>%1, as the program</source>
        <translation>%1 (このプログラムの既定値)</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>%1の下限</translation>
    </message>
    <message>
        <source>Most %1</source>
        <translation>%1の上限</translation>
    </message>
    <message>
        <source>%1 from, to</source>
        <translation>%1の下限、上限</translation>
    </message>
</context>
<context>
    <name>dialogs::MoveSheet</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1パルス</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Stop: HOLD</source>
        <translation>停止: HOLD</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Move at %1</source>
        <translation>移動 — %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>制御グループ</translation>
    </message>
    <message>
        <source>From</source>
        <translation>移動元</translation>
    </message>
    <message>
        <source>To</source>
        <translation>移動先</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>経路</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>所要時間</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>許容範囲</translation>
    </message>
    <message>
        <source>Stored points near the target</source>
        <translation>目標付近の登録点</translation>
    </message>
    <message>
        <source>A long move, or one that nobody can measure: type %1</source>
        <translation>長い移動、または長さの分からない移動です: %1と入力します</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>キーボードの場合: %1と入力し、F9を押します</translation>
    </message>
    <message>
        <source>HOLD stays on until it is released</source>
        <translation>HOLDは解除するまで有効です</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>ロボットが動きます</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>cannot be foretold in this frame</source>
        <translation>この座標では予測できません</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>約%1 秒</translation>
    </message>
    <message>
        <source>not known: a percentage of joint speed</source>
        <translation>不明: 関節速度の割合での指定</translation>
    </message>
    <message>
        <source>not known: the target is in pulses</source>
        <translation>不明: 目標がパルスでの指定</translation>
    </message>
    <message>
        <source>%1 mm and %2° between the ends; a joint move does not go straight</source>
        <translation>両端の間は%1 mm、%2°。関節動作は直線では動きません</translation>
    </message>
    <message>
        <source>%1 mm straight, turning %2°</source>
        <translation>直線で%1 mm、回転%2°</translation>
    </message>
    <message>
        <source>none is set for this controller</source>
        <translation>このコントローラには設定されていません</translation>
    </message>
    <message>
        <source>the whole way is inside</source>
        <translation>経路全体が範囲内です</translation>
    </message>
    <message>
        <source>both ends are inside; the way between is not known</source>
        <translation>両端は範囲内です。その間の経路は不明です</translation>
    </message>
    <message>
        <source>%1, at most %2 %</source>
        <translation>%1 (上限 %2 %)</translation>
    </message>
    <message>
        <source>%1, at most %2 mm/s</source>
        <translation>%1 (上限 %2 mm/s)</translation>
    </message>
    <message>
        <source>%1, at most %2 °/s</source>
        <translation>%1 (上限 %2 °/s)</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>比較できません</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 (距離 %2 mm)</translation>
    </message>
    <message>
        <source>none in the base frame was read</source>
        <translation>ベース座標の登録点は読み出していません</translation>
    </message>
    <message>
        <source>The robot is no longer where this move begins: close, and rehearse again.</source>
        <translation>ロボットはもうこの移動の開始位置にいません。閉じて、もう一度事前確認を行ってください。</translation>
    </message>
    <message>
        <source>Not sent: the place could not be read.</source>
        <translation>送信していません: 位置を読み出せませんでした。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>a place that was not read</source>
        <translation>読み出していない位置</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>移動中: %1</translation>
    </message>
    <message>
        <source>Move sent…</source>
        <translation>移動を送信しました…</translation>
    </message>
    <message>
        <source>Arrived: %1</source>
        <translation>到着: %1</translation>
    </message>
    <message>
        <source>Stopped at %1. That is not the target.</source>
        <translation>%1で停止しました。目標の位置ではありません。</translation>
    </message>
    <message>
        <source>At rest at %1. Whether that is the target cannot be told in this frame.</source>
        <translation>%1で静止しています。目標の位置かどうかは、この座標では判定できません。</translation>
    </message>
    <message>
        <source>No answer to the move: whether it was begun is unknown. It was sent once. Look at the robot.</source>
        <translation>移動への応答がありません。移動を始めたかどうかは不明です。送信は1回だけです。ロボットを確認してください。</translation>
    </message>
    <message>
        <source>The outcome is unknown: communication was lost, or it does not come to rest. Look at the robot.</source>
        <translation>結果は不明です。通信が途絶したか、ロボットが静止しません。ロボットを確認してください。</translation>
    </message>
</context>
<context>
    <name>dialogs::NumberingDialog</name>
    <message>
        <source>Variable numbering — %1</source>
        <translation>変数番号の方式 — %1</translation>
    </message>
    <message>
        <source>Number of the variable</source>
        <translation>変数の番号</translation>
    </message>
    <message>
        <source>Value on the pendant</source>
        <translation>ペンダントでの値</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>未読出し</translation>
    </message>
    <message>
        <source>reads on the pendant</source>
        <translation>のペンダント表示は</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Keep the result</source>
        <translation>結果を保存</translation>
    </message>
    <message>
        <source>Which number is which?</source>
        <translation>どの番号がどの変数か</translation>
    </message>
    <message>
        <source>Parameter RS022 decides whether B000 is number 0 or number 1 on the network. Until that is known, a write could hit the neighbour, so none is sent. Read two variables on the pendant (main menu, VARIABLE, BYTE) and enter what you see. This test only reads.</source>
        <translation>B000がネットワーク上で番号0か番号1かは、パラメータRS022で決まります。それが分かるまでは、書込みが隣の変数に当たるおそれがあるため、何も書き込みません。ペンダントで2つの変数を読み (メインメニュー、変数、バイト型)、表示された値を入力してください。このテストは読出しだけを行います。</translation>
    </message>
    <message>
        <source>The variables could not be read: %1.</source>
        <translation>変数を読み出せませんでした: %1。</translation>
    </message>
    <message>
        <source>All B variables hold the same value, which proves nothing: let a job or the pendant set B010 to 1 and B011 to 2, then open this test again.</source>
        <translation>すべてのB変数が同じ値のため、何も判定できません。ジョブかペンダントでB010を1、B011を2に設定してから、このテストをもう一度開いてください。</translation>
    </message>
    <message>
        <source>These two tell the numberings apart.</source>
        <translation>この2つで番号の方式を判別できます。</translation>
    </message>
    <message>
        <source>Verified: number 0 on the network is B000.</source>
        <translation>照合済み: ネットワーク上の番号0がB000です。</translation>
    </message>
    <message>
        <source>Verified, shifted: number 1 on the network is B000.</source>
        <translation>照合済み、ずれあり: ネットワーク上の番号1がB000です。</translation>
    </message>
    <message>
        <source>Both numberings fit these values: choose variables whose neighbours hold other values.</source>
        <translation>この値はどちらの方式にも合います。隣の変数が別の値になっている変数を選んでください。</translation>
    </message>
    <message>
        <source>Neither numbering fits: read the values again, they may have changed.</source>
        <translation>どちらの方式にも合いません。値が変わった可能性があるため、もう一度読んでください。</translation>
    </message>
</context>
<context>
    <name>dialogs::OverwriteDialog</name>
    <message numerus="yes">
        <source>For the remaining %n file(s) too</source>
        <translation>
            <numerusform>残りの%n個のファイルにも適用</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” exists</source>
        <translation>「%1」はすでにあります</translation>
    </message>
    <message>
        <source>There is a file “%1” %2 already.</source>
        <translation>%2にファイル「%1」がすでにあります。</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>比較(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>置換え(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keep both</source>
        <translation>両方を残す(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>スキップ(&amp;S)</translation>
    </message>
</context>
<context>
    <name>dialogs::PasscodeDialog</name>
    <message>
        <source>The passcode guards against mistakes, not against attackers: whoever can change this user&apos;s files can remove it.</source>
        <translation>パスコードは誤操作を防ぐもので、攻撃を防ぐものではありません。このユーザのファイルを変更できる人は、パスコードを外せます。</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>アクセスレベル: %1</translation>
    </message>
    <message>
        <source>Passcode</source>
        <translation>パスコード</translation>
    </message>
    <message>
        <source>That is not the passcode.</source>
        <translation>パスコードが違います。</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>確認しています…</translation>
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
        <translation>タイプ</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>書込み予定に追加</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1または%2</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>ユーザ座標</translation>
    </message>
    <message>
        <source>Take the present position of R1 (base frame)</source>
        <translation>R1の現在位置を取込み (ベース座標)</translation>
    </message>
    <message>
        <source>Take R1 in pulses</source>
        <translation>R1をパルスで取込み</translation>
    </message>
    <message>
        <source>Take the present position of B1 (base frame)</source>
        <translation>B1の現在位置を取込み (ベース座標)</translation>
    </message>
    <message>
        <source>Take B1 in pulses</source>
        <translation>B1をパルスで取込み</translation>
    </message>
    <message>
        <source>Take the present position of S1</source>
        <translation>S1の現在位置を取込み</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>ライブ: %1</translation>
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
        <translation>ユーザ座標の位置には、1から63までのユーザ座標番号が必要です。</translation>
    </message>
    <message>
        <source>Sources disagree which code means user and which means tool frame: check on the pendant before a job uses this position.</source>
        <translation>どのコードがユーザ座標でどのコードがツール座標かは、資料によって異なります。ジョブでこの位置を使う前に、ペンダントで確認してください。</translation>
    </message>
    <message>
        <source>The position is being read…</source>
        <translation>位置を読み出しています…</translation>
    </message>
    <message>
        <source>The position could not be read: %1.</source>
        <translation>位置を読み出せませんでした: %1。</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形態</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>拡張形態</translation>
    </message>
</context>
<context>
    <name>dialogs::ProfileForm</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Host name or address</source>
        <translation>ホスト名またはアドレス</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>機種</translation>
    </message>
    <message>
        <source>Text encoding</source>
        <translation>文字コード</translation>
    </message>
    <message>
        <source>Variable numbering</source>
        <translation>変数番号の方式</translation>
    </message>
    <message>
        <source>B000 is number 0 on the wire</source>
        <translation>B000は通信上の番号0</translation>
    </message>
    <message>
        <source>B000 is number 1 on the wire</source>
        <translation>B000は通信上の番号1</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>ポート</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>ファイルポート</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>読出しタイムアウト</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>ファイルタイムアウト</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>サーボタイムアウト</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>読出しの再試行回数</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>同時に応答を待つ要求数</translation>
    </message>
    <message>
        <source>Requests a second, at most</source>
        <translation>1秒あたりの最大要求数</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>%1から%2まで</translation>
    </message>
    <message>
        <source>Jog and move, at most</source>
        <translation>ジョグと移動の上限</translation>
    </message>
</context>
<context>
    <name>dialogs::ReadinessSheet</name>
    <message>
        <source>Readiness — %1</source>
        <translation>準備状態 — %1</translation>
    </message>
    <message>
        <source>What %1 allows now</source>
        <translation>%1が現在許可していること</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>準備状態</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the readiness and a diagnosis</source>
        <translation>準備状態と診断をコピー</translation>
    </message>
    <message>
        <source>As text for support, with a diagnosis of the link, which takes a moment.</source>
        <translation>サポート用のテキストとしてコピーします。リンクの診断を含むため、少し時間がかかります。</translation>
    </message>
    <message>
        <source>Test numbering…</source>
        <translation>変数番号のテスト…</translation>
    </message>
    <message>
        <source>It needs a link to the controller.</source>
        <translation>コントローラとのリンクが必要です。</translation>
    </message>
    <message>
        <source>Communication lost at %1: what is hatched was read before.</source>
        <translation>通信途絶 (%1): 斜線の部分は途絶前に読み出したものです。</translation>
    </message>
    <message>
        <source>%1 has not answered yet.</source>
        <translation>%1はまだ応答していません。</translation>
    </message>
    <message>
        <source>Not connected: nothing is read.</source>
        <translation>未接続のため、何も読み出していません。</translation>
    </message>
    <message>
        <source>The status was not read just now.</source>
        <translation>状態の情報が最新ではありません。</translation>
    </message>
    <message>
        <source>It is read live and changes nothing. HOLD works meanwhile: Pause key.</source>
        <translation>ライブで読み出しており、何も変更しません。その間もHOLDは有効です: Pauseキー。</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>コピーしました</translation>
    </message>
</context>
<context>
    <name>dialogs::RestoreDialog</name>
    <message>
        <source>Put that file back</source>
        <translation>そのファイルを元に戻す</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Restore %1 from %2</source>
        <translation>%2から%1を復元</translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation>実行される内容</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>処理</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>+ new: it is sent</source>
        <translation>+ 新規: 送信します</translation>
    </message>
    <message>
        <source>≠ changed: it is replaced</source>
        <translation>≠ 変更あり: 置き換えます</translation>
    </message>
    <message>
        <source>= same: left alone</source>
        <translation>= 同じ: そのままにします</translation>
    </message>
    <message>
        <source>▲ not allowed: left alone</source>
        <translation>▲ 許可されていません: そのままにします</translation>
    </message>
    <message numerus="yes">
        <source>Back up, then restore %n file(s)</source>
        <translation>
            <numerusform>バックアップしてから%n個のファイルを復元</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are the same and not listed.</source>
        <translation>
            <numerusform>%n個のファイルは同じため、表示していません。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Sending file %1 of %2…</source>
        <translation>ファイルを送信しています (%1 / %2)…</translation>
    </message>
    <message>
        <source>Fresh backup: file %1 of %2…</source>
        <translation>新しいバックアップ: ファイル %1 / %2…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored and read back.</source>
        <translation>
            <numerusform>%n個のファイルを復元し、読み戻しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored before that.</source>
        <translation>
            <numerusform>その前に%n個のファイルを復元しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>中止しました。</translation>
    </message>
    <message>
        <source>Stopped at %1.</source>
        <translation>%1で停止しました。</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>何も送信していません。</translation>
    </message>
    <message>
        <source>The file is as it was before.</source>
        <translation>ファイルは以前のままです。</translation>
    </message>
    <message>
        <source>▲ The file could not be put back. Look at the controller.</source>
        <translation>▲ ファイルを元に戻せませんでした。コントローラを確認してください。</translation>
    </message>
    <message>
        <source>A fresh backup of %1 is made first. Then the files below are sent one by one and read back. A refused file is left out; it stops at any other error.</source>
        <translation>最初に%1の新しいバックアップを作成します。次に、下のファイルを1つずつ送信し、読み戻します。拒否されたファイルは除きます。それ以外のエラーでは停止します。</translation>
    </message>
    <message>
        <source>%1: the backup is of %2, the controller is %3.</source>
        <translation>%1: バックアップは%2、コントローラは%3です。</translation>
    </message>
    <message>
        <source>This is the backup of another robot: nothing of it is sent.</source>
        <translation>別のロボットのバックアップです。何も送信しません。</translation>
    </message>
    <message>
        <source>The controller refused %1; the other files were sent.</source>
        <translation>コントローラが%1を拒否しました。ほかのファイルは送信しました。</translation>
    </message>
</context>
<context>
    <name>dialogs::SignalPicker</name>
    <message>
        <source>Add a signal</source>
        <translation>信号を追加</translation>
    </message>
    <message>
        <source>For example: R1 torque, B005, #00010, M012</source>
        <translation>例: R1 torque, B005, #00010, M012</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>dialogs::StartSheet</name>
    <message>
        <source>Start</source>
        <translation>起動</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Start at %1</source>
        <translation>起動 — %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>開始行</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>サイクル</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>速度オーバーライド</translation>
    </message>
    <message>
        <source>HOLD: Pause key</source>
        <translation>HOLD: Pauseキー</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>ロボットが動きます</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>キーボードの場合: %1と入力し、F9を押します</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Start sent…</source>
        <translation>起動を送信しました…</translation>
    </message>
    <message>
        <source>Accepted. Waiting for RUN…</source>
        <translation>受け付けられました。RUNを待っています…</translation>
    </message>
    <message>
        <source>The start was accepted, but no RUN was seen for 3 s. Usual causes: the job was so short that it has ended, it waits for a condition of the cell, or the pendant shows a question. Look at the pendant.</source>
        <translation>起動は受け付けられましたが、3秒間RUNになりませんでした。よくある原因: ジョブが短くてすでに終わった、セルの条件を待っている、ペンダントに確認の問いが出ている。ペンダントを確認してください。</translation>
    </message>
    <message>
        <source>No answer to the start: it may or may not have happened. Reading the status…</source>
        <translation>起動への応答がありません。起動したかどうかは不明です。状態を読み出しています…</translation>
    </message>
    <message>
        <source>No answer to the start, and none to the status: whether the robot runs is unknown. Look at it.</source>
        <translation>起動にも状態の読出しにも応答がありません。ロボットが運転中かどうかは不明です。ロボットを確認してください。</translation>
    </message>
    <message>
        <source>No answer to the start, but a status that was read afterwards said RUN. It was sent once.</source>
        <translation>起動への応答はありませんが、その後に読み出した状態はRUNでした。送信は1回だけです。</translation>
    </message>
    <message>
        <source>No answer to the start, and a status that was read afterwards said no RUN. Look at the robot before you start again.</source>
        <translation>起動への応答がなく、その後に読み出した状態もRUNではありません。再び起動する前に、ロボットを確認してください。</translation>
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
        <translation>条件</translation>
    </message>
    <message>
        <source>What must be the case</source>
        <translation>必要な条件</translation>
    </message>
</context>
<context>
    <name>files::Identity</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>ホスト</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>機種</translation>
    </message>
    <message>
        <source>Robots and axes</source>
        <translation>ロボットと軸</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>ソフトウェア</translation>
    </message>
    <message>
        <source>Number of variables</source>
        <translation>変数の数</translation>
    </message>
</context>
<context>
    <name>files::Restore</name>
    <message>
        <source>It is not in the backup.</source>
        <translation>バックアップにありません。</translation>
    </message>
    <message>
        <source>What the controller has could not be read.</source>
        <translation>コントローラにある内容を読み出せませんでした。</translation>
    </message>
    <message>
        <source>In the backup it is not as it was written.</source>
        <translation>バックアップの内容が、書き込んだときと異なります。</translation>
    </message>
    <message>
        <source>It belongs to this one controller, or only tells what happened: it is never sent.</source>
        <translation>このコントローラに固有のもの、または経過の記録のため、送信しません。</translation>
    </message>
    <message>
        <source>It comes from another robot.</source>
        <translation>別のロボットのものです。</translation>
    </message>
    <message>
        <source>It changes how the robot moves, or what protects people: look at the differences and choose it.</source>
        <translation>ロボットの動作または人の保護に関わる設定が変わります。違いを確認してから選んでください。</translation>
    </message>
</context>
<context>
    <name>files::Verify</name>
    <message>
        <source>This is no backup: %1 is missing or of another kind.</source>
        <translation>バックアップではありません: %1がないか、種類が違います。</translation>
    </message>
    <message>
        <source>%1 is not as it was written.</source>
        <translation>%1が書き込んだときと異なります。</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1は変更されています。</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1がありません。</translation>
    </message>
    <message>
        <source>%1 does not belong to the backup.</source>
        <translation>%1はバックアップに属していません。</translation>
    </message>
</context>
<context>
    <name>inform::Check</name>
    <message>
        <source>The file is empty.</source>
        <translation>ファイルが空です。</translation>
    </message>
    <message>
        <source>HSES cannot carry it.</source>
        <translation>HSESでは転送できません。</translation>
    </message>
    <message>
        <source>“%1” is no type of file that can be sent.</source>
        <translation>「%1」は送信できるファイルのタイプではありません。</translation>
    </message>
    <message>
        <source>Controllers take JBI, JBR, CND, DAT, PRM and LST.</source>
        <translation>コントローラが受け付けるのはJBI、JBR、CND、DAT、PRM、LSTです。</translation>
    </message>
    <message>
        <source>The type of the file is written in small letters.</source>
        <translation>ファイルのタイプが小文字です。</translation>
    </message>
    <message>
        <source>Controllers write it in capitals.</source>
        <translation>コントローラは大文字で書きます。</translation>
    </message>
    <message>
        <source>The header names the job “%1”.</source>
        <translation>ヘッダのジョブ名は「%1」です。</translation>
    </message>
    <message>
        <source>The name in the header counts: that job would be written.</source>
        <translation>ヘッダの名前が有効です。そのジョブに書き込まれます。</translation>
    </message>
    <message>
        <source>The job is being executed.</source>
        <translation>このジョブは実行中です。</translation>
    </message>
    <message>
        <source>A running job cannot be replaced.</source>
        <translation>運転中のジョブは置き換えられません。</translation>
    </message>
    <message>
        <source>All names in the controller become those in this file.</source>
        <translation>コントローラの名称はすべて、このファイルのものに置き換わります。</translation>
    </message>
    <message>
        <source>Back them up first.</source>
        <translation>先にバックアップしてください。</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark.</source>
        <translation>ファイルの先頭にバイトオーダーマークがあります。</translation>
    </message>
    <message>
        <source>Controllers know no such mark: save the file without it.</source>
        <translation>コントローラはこのマークに対応していません。マークなしで保存してください。</translation>
    </message>
    <message>
        <source>The file is UTF-16 text.</source>
        <translation>ファイルがUTF-16のテキストです。</translation>
    </message>
    <message>
        <source>Controllers take one byte for a letter.</source>
        <translation>コントローラは1文字を1バイトとして扱います。</translation>
    </message>
    <message>
        <source>The lines end in CR alone.</source>
        <translation>行末がCRだけです。</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (pendant 3200).</source>
        <translation>行末はCR LFです。このままではNOPもENDも見つかりません (ペンダント3200)。</translation>
    </message>
    <message>
        <source>Lines end in LF alone.</source>
        <translation>行末がLFだけです。</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (0x5130, pendant 3200).</source>
        <translation>行末はCR LFです。このままではNOPもENDも見つかりません (0x5130、ペンダント3200)。</translation>
    </message>
    <message>
        <source>Lines end in CR LF; a controller may read such a file as empty.</source>
        <translation>行末はCR LFです。コントローラがこのファイルを空と読むことがあります。</translation>
    </message>
    <message>
        <source>The last line does not end.</source>
        <translation>最後の行に行末がありません。</translation>
    </message>
    <message>
        <source>Controllers end each line in CR LF.</source>
        <translation>コントローラは各行をCR LFで終わります。</translation>
    </message>
    <message>
        <source>There is a Ctrl-Z at the end.</source>
        <translation>末尾にCtrl-Zがあります。</translation>
    </message>
    <message>
        <source>It stands behind END, which must be last (0x5130).</source>
        <translation>最後でなければならないENDの後にあります (0x5130)。</translation>
    </message>
    <message>
        <source>There is a control character.</source>
        <translation>制御文字があります。</translation>
    </message>
    <message>
        <source>No line of a job may have one.</source>
        <translation>ジョブの行に制御文字は使えません。</translation>
    </message>
    <message>
        <source>This is no job: it does not have the line /JOB.</source>
        <translation>ジョブではありません。/JOBの行がありません。</translation>
    </message>
    <message>
        <source>A job begins with it (0x5310).</source>
        <translation>ジョブはこの行で始まります (0x5310)。</translation>
    </message>
    <message>
        <source>The file holds more than one job.</source>
        <translation>ファイルに複数のジョブがあります。</translation>
    </message>
    <message>
        <source>Only the first one was looked at.</source>
        <translation>最初のジョブだけを確認しました。</translation>
    </message>
    <message>
        <source>“%1” is no name for a job.</source>
        <translation>「%1」はジョブ名に使えません。</translation>
    </message>
    <message>
        <source>A name has 1 to 32 bytes, no blanks and none of the signs that names of files may not have (0x4190).</source>
        <translation>名前は1から32バイトで、空白とファイル名に使えない記号は使えません (0x4190)。</translation>
    </message>
    <message>
        <source>There is text that belongs to no section.</source>
        <translation>どのセクションにも属さない文字列があります。</translation>
    </message>
    <message>
        <source>It is no INFORM (0x5310).</source>
        <translation>INFORMではありません (0x5310)。</translation>
    </message>
    <message>
        <source>%1 is no known pseudo instruction.</source>
        <translation>%1は既知の疑似命令ではありません。</translation>
    </message>
    <message>
        <source>A controller that does not know it refuses the file (0x5340).</source>
        <translation>これに対応していないコントローラはファイルを拒否します (0x5340)。</translation>
    </message>
    <message>
        <source>The comment of the job is longer than 32 bytes.</source>
        <translation>ジョブのコメントが32バイトを超えています。</translation>
    </message>
    <message>
        <source>Controllers cut it or refuse it.</source>
        <translation>コントローラはこれを切り詰めるか、拒否します。</translation>
    </message>
    <message>
        <source>A frame is given, and the attribute RJ is missing.</source>
        <translation>座標が指定されていますが、属性RJがありません。</translation>
    </message>
    <message>
        <source>Only relative jobs have a frame (0x4490).</source>
        <translation>座標を持つのは相対ジョブだけです (0x4490)。</translation>
    </message>
    <message>
        <source>The job is relative, and no frame is given.</source>
        <translation>相対ジョブですが、座標が指定されていません。</translation>
    </message>
    <message>
        <source>A relative job names its frame (0x3390).</source>
        <translation>相対ジョブには座標の指定が必要です (0x3390)。</translation>
    </message>
    <message>
        <source>There are positions, and no ///NPOS that counts them.</source>
        <translation>位置がありますが、その数を示す///NPOSがありません。</translation>
    </message>
    <message>
        <source>The controller compares them (0x5180).</source>
        <translation>コントローラは両者を比較します (0x5180)。</translation>
    </message>
    <message>
        <source>///NPOS does not count the positions of each kind: %1 (kind, said, found).</source>
        <translation>///NPOSの数が種類ごとの位置の数と合いません: %1 (種類、記載数、実数)。</translation>
    </message>
    <message>
        <source>There is text among the positions that is none.</source>
        <translation>位置の中に、位置ではない文字列があります。</translation>
    </message>
    <message>
        <source>Every line of //POS is a position or a pseudo instruction (0x5120).</source>
        <translation>//POSの各行は位置または疑似命令です (0x5120)。</translation>
    </message>
    <message>
        <source>%1 is there twice.</source>
        <translation>%1が2つあります。</translation>
    </message>
    <message>
        <source>Each position has one entry (0x5120).</source>
        <translation>各位置の項目は1つです (0x5120)。</translation>
    </message>
    <message>
        <source>%1 is named by no line.</source>
        <translation>%1を使う行がありません。</translation>
    </message>
    <message>
        <source>Each taught point belongs to one instruction (pendant 3190).</source>
        <translation>教示点はそれぞれ1つの命令に属します (ペンダント3190)。</translation>
    </message>
    <message>
        <source>%1 has no entry among the positions.</source>
        <translation>%1が位置の中にありません。</translation>
    </message>
    <message>
        <source>The robot would not know where to go (0x4130).</source>
        <translation>ロボットの移動先が決まりません (0x4130)。</translation>
    </message>
    <message>
        <source>%1 is named in two places.</source>
        <translation>%1が2か所で使われています。</translation>
    </message>
    <message>
        <source>Controllers give each place a point of its own.</source>
        <translation>コントローラは、使用箇所ごとに別の点を割り当てます。</translation>
    </message>
    <message>
        <source>The number of values does not fit the axes: %1 (position, values).</source>
        <translation>値の数が軸の数と合いません: %1 (位置、値の数)。</translation>
    </message>
    <message>
        <source>A robot has 6 or 7 axes, a base 1 to 3, a station 1 to 6 (0x5180).</source>
        <translation>ロボットは6または7軸、ベースは1から3軸、ステーションは1から6軸です (0x5180)。</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1に数値ではない値があります。</translation>
    </message>
    <message>
        <source>The controller cannot read it (0x5120).</source>
        <translation>コントローラはこれを読み取れません (0x5120)。</translation>
    </message>
    <message>
        <source>The line ///PULSE, ///RECTAN or ///ANGLE before %1 does not fit its ///POSTYPE.</source>
        <translation>%1の前の///PULSE、///RECTANまたは///ANGLEの行が、///POSTYPEと合いません。</translation>
    </message>
    <message>
        <source>PULSE goes with ///PULSE, ANGLE with ///ANGLE, the others with ///RECTAN (0x5120).</source>
        <translation>PULSEには///PULSE、ANGLEには///ANGLE、その他には///RECTANを使います (0x5120)。</translation>
    </message>
    <message>
        <source>%1 is in pulses, and the job is relative.</source>
        <translation>%1はパルスですが、ジョブは相対ジョブです。</translation>
    </message>
    <message>
        <source>The points of a relative job stand in its frame.</source>
        <translation>相対ジョブの点はその座標で表します。</translation>
    </message>
    <message>
        <source>There are taught points (%1), and the job has no control group.</source>
        <translation>教示点がありますが (%1)、ジョブに制御グループがありません。</translation>
    </message>
    <message>
        <source>A job without a group cannot move (0x5430).</source>
        <translation>制御グループのないジョブは移動できません (0x5430)。</translation>
    </message>
    <message>
        <source>There are %1 points, and no control group of the job has such axes.</source>
        <translation>%1の点がありますが、ジョブの制御グループにその軸がありません。</translation>
    </message>
    <message>
        <source>C needs a robot, BC a base, EC a station among the groups (0x3370).</source>
        <translation>Cにはロボット、BCにはベース、ECにはステーションのグループが必要です (0x3370)。</translation>
    </message>
    <message>
        <source>The first instruction is not NOP.</source>
        <translation>最初の命令がNOPではありません。</translation>
    </message>
    <message>
        <source>Every job begins with NOP (0x5130, pendant 3200).</source>
        <translation>ジョブは必ずNOPで始まります (0x5130、ペンダント3200)。</translation>
    </message>
    <message>
        <source>The last instruction is not END.</source>
        <translation>最後の命令がENDではありません。</translation>
    </message>
    <message>
        <source>Every job ends with END (0x5130, pendant 3200).</source>
        <translation>ジョブは必ずENDで終わります (0x5130、ペンダント3200)。</translation>
    </message>
    <message>
        <source>There is an END before the last line.</source>
        <translation>最後の行より前にENDがあります。</translation>
    </message>
    <message>
        <source>What follows it is no job (0x5130).</source>
        <translation>その後はジョブになりません (0x5130)。</translation>
    </message>
    <message>
        <source>The line begins with no instruction.</source>
        <translation>行が命令で始まっていません。</translation>
    </message>
    <message>
        <source>An instruction was cut in two: it belongs to the line before (0x5110).</source>
        <translation>命令が2行に分かれています。前の行に属します (0x5110)。</translation>
    </message>
    <message>
        <source>%1 is no instruction that this program knows.</source>
        <translation>%1は、このプログラムが知っている命令ではありません。</translation>
    </message>
    <message>
        <source>It may belong to an option; a controller without it refuses the job (0x5110).</source>
        <translation>オプションの命令かもしれません。そのオプションのないコントローラはジョブを拒否します (0x5110)。</translation>
    </message>
    <message>
        <source>There are characters beyond ASCII outside of comments and texts.</source>
        <translation>コメントと文字列以外の部分に、ASCII以外の文字があります。</translation>
    </message>
    <message>
        <source>Instructions are ASCII.</source>
        <translation>命令はASCIIです。</translation>
    </message>
    <message>
        <source>There is an empty line among the instructions.</source>
        <translation>命令の間に空行があります。</translation>
    </message>
    <message>
        <source>Controllers write none.</source>
        <translation>コントローラは空行を書きません。</translation>
    </message>
    <message>
        <source>The job has more than 10,000 lines.</source>
        <translation>ジョブが10,000行を超えています。</translation>
    </message>
    <message>
        <source>Controllers number lines to 9999.</source>
        <translation>コントローラの行番号は9999までです。</translation>
    </message>
    <message>
        <source>A comment or message is longer than 32 bytes.</source>
        <translation>コメントまたはメッセージが32バイトを超えています。</translation>
    </message>
    <message>
        <source>Controllers cut it.</source>
        <translation>コントローラはこれを切り詰めます。</translation>
    </message>
    <message>
        <source>The label *%1 is longer than 8 bytes.</source>
        <translation>ラベル*%1が8バイトを超えています。</translation>
    </message>
    <message>
        <source>Labels have 1 to 8 (0x4200).</source>
        <translation>ラベルは1から8バイトです (0x4200)。</translation>
    </message>
    <message>
        <source>The label *%1 is there twice.</source>
        <translation>ラベル*%1が2つあります。</translation>
    </message>
    <message>
        <source>A jump would have two goals (0x4200).</source>
        <translation>ジャンプ先が2つになります (0x4200)。</translation>
    </message>
    <message>
        <source>There is no label *%1.</source>
        <translation>ラベル*%1がありません。</translation>
    </message>
    <message>
        <source>The jump gives an alarm when it is executed.</source>
        <translation>このジャンプを実行するとアラームになります。</translation>
    </message>
    <message>
        <source>%1 is not closed.</source>
        <translation>%1が閉じられていません。</translation>
    </message>
    <message>
        <source>IFTHEN needs ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</source>
        <translation>IFTHENにはENDIF、WHILEにはENDWHILE、FORにはNEXT、SWITCHにはENDSWITCHが必要です (0x5110)。</translation>
    </message>
    <message>
        <source>%1 stands outside of what it belongs to.</source>
        <translation>%1が、属するべき構造の外にあります。</translation>
    </message>
    <message>
        <source>Structures are closed in the reverse order (0x5110).</source>
        <translation>構造は逆の順に閉じます (0x5110)。</translation>
    </message>
    <message>
        <source>Structures are nested more than 10 deep.</source>
        <translation>構造の入れ子が10段を超えています。</translation>
    </message>
    <message>
        <source>Controllers allow 10.</source>
        <translation>コントローラで使えるのは10段までです。</translation>
    </message>
    <message>
        <source>%1 is out of range.</source>
        <translation>%1は範囲外です。</translation>
    </message>
    <message>
        <source>The controller may refuse it (0x5200).</source>
        <translation>コントローラが拒否することがあります (0x5200)。</translation>
    </message>
    <message>
        <source>There are more than 8 arguments.</source>
        <translation>引数が8個を超えています。</translation>
    </message>
    <message>
        <source>A job takes 8 (0x5110).</source>
        <translation>ジョブの引数は8個までです (0x5110)。</translation>
    </message>
    <message>
        <source>%1 is beyond what ///LVARS provides.</source>
        <translation>%1は///LVARSで確保した範囲を超えています。</translation>
    </message>
    <message>
        <source>The job has fewer local variables (0x5110).</source>
        <translation>ジョブのローカル変数の数が足りません (0x5110)。</translation>
    </message>
    <message>
        <source>Line %1 of the file, named by line %2: %3</source>
        <translation>ファイルの%1行目 (%2行目で使用): %3</translation>
    </message>
    <message>
        <source>Line %1 (%2 in the file): %3</source>
        <translation>%1行目 (ファイルの%2行目): %3</translation>
    </message>
    <message>
        <source>Line %1 of the file: %2</source>
        <translation>ファイルの%1行目: %2</translation>
    </message>
    <message>
        <source>There is no ///NPOS.</source>
        <translation>///NPOSがありません。</translation>
    </message>
</context>
<context>
    <name>inform::JobDiff</name>
    <message>
        <source>arm form: field %1 of RCONF %2 → %3</source>
        <translation>アームの形態: RCONFのフィールド%1 %2 → %3</translation>
    </message>
    <message>
        <source>arm form: %1 → %2</source>
        <translation>アームの形態: %1 → %2</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>軸%1</translation>
    </message>
    <message>
        <source>%1 pulses in %2</source>
        <translation>%2 %1パルス</translation>
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
        <translation>合計 %1</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>移動 %1</translation>
    </message>
    <message>
        <source>moved %1 (%2)</source>
        <translation>移動 %1 (%2)</translation>
    </message>
    <message>
        <source>type %1 → %2</source>
        <translation>タイプ %1 → %2</translation>
    </message>
    <message>
        <source>tool %1 → %2</source>
        <translation>ツール %1 → %2</translation>
    </message>
    <message>
        <source>user frame %1 → %2</source>
        <translation>ユーザ座標 %1 → %2</translation>
    </message>
    <message>
        <source>marked as beyond the limit</source>
        <translation>リミット超過の印を追加</translation>
    </message>
    <message>
        <source>no longer marked as beyond the limit</source>
        <translation>リミット超過の印を削除</translation>
    </message>
    <message>
        <source>values %1 → %2</source>
        <translation>値 %1 → %2</translation>
    </message>
    <message>
        <source>Made a relative job</source>
        <translation>相対ジョブに変更</translation>
    </message>
    <message>
        <source>No longer a relative job</source>
        <translation>相対ジョブではなくなりました</translation>
    </message>
    <message>
        <source>The job is locked against editing</source>
        <translation>ジョブは編集禁止です</translation>
    </message>
    <message>
        <source>The job is no longer locked against editing</source>
        <translation>ジョブの編集禁止は解除されました</translation>
    </message>
    <message>
        <source>Made a macro job</source>
        <translation>マクロジョブに変更</translation>
    </message>
    <message>
        <source>No longer a macro job</source>
        <translation>マクロジョブではなくなりました</translation>
    </message>
    <message>
        <source>Attribute %1 added</source>
        <translation>属性%1を追加</translation>
    </message>
    <message>
        <source>Attribute %1 removed</source>
        <translation>属性%1を削除</translation>
    </message>
    <message>
        <source>Relative frame %1 added</source>
        <translation>相対座標%1を追加</translation>
    </message>
    <message>
        <source>Relative frame %1 removed</source>
        <translation>相対座標%1を削除</translation>
    </message>
    <message>
        <source>Relative frame: %1 → %2</source>
        <translation>相対座標: %1 → %2</translation>
    </message>
    <message>
        <source>Job name: “%1” → “%2”</source>
        <translation>ジョブ名: 「%1」 → 「%2」</translation>
    </message>
    <message>
        <source>Job folder: “%1” → “%2”</source>
        <translation>ジョブフォルダ: 「%1」 → 「%2」</translation>
    </message>
    <message>
        <source>Comment of the job: “%1” → “%2”</source>
        <translation>ジョブのコメント: 「%1」 → 「%2」</translation>
    </message>
    <message>
        <source>Control group GROUP%1: %2 → %3</source>
        <translation>制御グループGROUP%1: %2 → %3</translation>
    </message>
    <message>
        <source>Control group GROUP%1 added: %2</source>
        <translation>制御グループGROUP%1を追加: %2</translation>
    </message>
    <message>
        <source>Control group GROUP%1 removed: %2</source>
        <translation>制御グループGROUP%1を削除: %2</translation>
    </message>
    <message>
        <source>Local variables %1: %2 → %3</source>
        <translation>ローカル変数%1: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1: %2 → %3</source>
        <translation>%1の別名: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1 added: %2</source>
        <translation>%1の別名を追加: %2</translation>
    </message>
    <message>
        <source>Alias of %1 removed: %2</source>
        <translation>%1の別名を削除: %2</translation>
    </message>
    <message>
        <source>Argument %1: “%2” → “%3”</source>
        <translation>引数%1: 「%2」 → 「%3」</translation>
    </message>
    <message>
        <source>Line %1 %2</source>
        <translation>%1行目 %2</translation>
    </message>
    <message>
        <source>Line %1 %2 of %3</source>
        <translation>%1行目 %3の%2</translation>
    </message>
    <message>
        <source>%1: %2 %3 added</source>
        <translation>%1: %2 %3を追加</translation>
    </message>
    <message>
        <source>%1: %2 %3 removed</source>
        <translation>%1: %2 %3を削除</translation>
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
        <translation>%1行目を追加: %2</translation>
    </message>
    <message>
        <source>Line %1 added: %2 (new point: %3)</source>
        <translation>%1行目を追加: %2 (新しい点: %3)</translation>
    </message>
    <message>
        <source>Line %1 removed: %2</source>
        <translation>%1行目を削除: %2</translation>
    </message>
    <message>
        <source>Line %1 removed: %2 (with its point: %3)</source>
        <translation>%1行目を削除: %2 (その点も削除: %3)</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) moved from line %1 to line %2</source>
        <translation>
            <numerusform>%n行を%1行目から%2行目に移動</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 commented out: %2</source>
        <translation>%1行目をコメントアウト: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer commented out: %2</source>
        <translation>%1行目のコメントアウトを解除: %2</translation>
    </message>
    <message>
        <source>Line %1 locked against editing: %2</source>
        <translation>%1行目を編集禁止: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer locked against editing: %2</source>
        <translation>%1行目の編集禁止を解除: %2</translation>
    </message>
    <message>
        <source>Line %1, comment: “%2” → “%3”</source>
        <translation>%1行目のコメント: 「%2」 → 「%3」</translation>
    </message>
    <message>
        <source>Line %1, comment added: “%2”</source>
        <translation>%1行目のコメントを追加: 「%2」</translation>
    </message>
    <message>
        <source>Line %1, comment removed: “%2”</source>
        <translation>%1行目のコメントを削除: 「%2」</translation>
    </message>
    <message>
        <source>Line %1: %2 → %3</source>
        <translation>%1行目: %2 → %3</translation>
    </message>
    <message>
        <source>%1 added: %2</source>
        <comment>a position</comment>
        <translation>%1を追加: %2</translation>
    </message>
    <message>
        <source>%1 removed: %2</source>
        <comment>a position</comment>
        <translation>%1を削除: %2</translation>
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
        <translation>操作履歴の%n件の記録が失われました。操作履歴にも%1にも書き込めませんでした。</translation>
    </message>
    <message>
        <source>%n record(s) could not be written into the journal. Orders and notes are kept in %1.</source>
        <translation>%n件の記録を操作履歴に書き込めませんでした。指令とメモは%1に保存しています。</translation>
    </message>
    <message>
        <source>What an earlier program left for the journal cannot be read: %1</source>
        <translation>以前のプログラムが操作履歴用に残したものを読み取れません: %1</translation>
    </message>
</context>
<context>
    <name>journal::Database</name>
    <message>
        <source>The folder of the journal cannot be made.</source>
        <translation>操作履歴のフォルダを作成できません。</translation>
    </message>
    <message>
        <source>The journal was made by a newer version of Pendesk.</source>
        <translation>この操作履歴は、より新しいバージョンのPendeskで作成されています。</translation>
    </message>
    <message>
        <source>The damaged journal cannot be given another name.</source>
        <translation>破損した操作履歴の名前を変更できません。</translation>
    </message>
</context>
<context>
    <name>journal::Store</name>
    <message>
        <source>The journal cannot be written: %1. Work goes on; records wait in memory.</source>
        <translation>操作履歴に書き込めません: %1。動作は続けます。記録はメモリで待機しています。</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>ディスクが応答しません</translation>
    </message>
</context>
<context>
    <name>models::ActiveAlarmModel</name>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>コード</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>サブコード</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>コントローラ時刻</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>初回確認</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>回数</translation>
    </message>
    <message>
        <source>The controller tells the newest four alarms only, and this is not one of them. It may be active.</source>
        <translation>コントローラが知らせるのは最新の4つのアラームだけで、これはその中にありません。発生中の可能性があります。</translation>
    </message>
    <message>
        <source>First seen by this computer: %1</source>
        <translation>このコンピュータでの初回確認: %1</translation>
    </message>
</context>
<context>
    <name>models::AlarmHistoryModel</name>
    <message>
        <source>Controller time</source>
        <translation>コントローラ時刻</translation>
    </message>
    <message>
        <source>List</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>コード</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>サブコード</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Read here</source>
        <translation>読出し時刻</translation>
    </message>
</context>
<context>
    <name>models::CodeStatisticsModel</name>
    <message>
        <source>Code</source>
        <translation>コード</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>回数</translation>
    </message>
    <message>
        <source>Mean time between</source>
        <translation>平均間隔</translation>
    </message>
    <message>
        <source>Last, controller time</source>
        <translation>最終、コントローラ時刻</translation>
    </message>
    <message>
        <source>%1 d %2 h</source>
        <translation>%1日 %2時間</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1時間 %2分</translation>
    </message>
    <message>
        <source>under a minute</source>
        <translation>1分未満</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
</context>
<context>
    <name>models::FleetModel</name>
    <message>
        <source>ALARM</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>HELD</source>
        <translation>ホールド中</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>ホールド: %1</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>運転中</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>NO LINK</source>
        <translation>リンクなし</translation>
    </message>
    <message>
        <source>CHECKING</source>
        <translation>確認中</translation>
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
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>往復時間</translation>
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
        <translation>拒否</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
</context>
<context>
    <name>models::JobListModel</name>
    <message>
        <source>%1 is being executed.</source>
        <translation>%1は実行中です。</translation>
    </message>
    <message>
        <source>%1, favourite</source>
        <translation>%1、お気に入り</translation>
    </message>
</context>
<context>
    <name>models::OrderModel</name>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>応答</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>実行者</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>コンピュータ</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
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
        <translation>待機中</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>転送中</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>done, read back identical</source>
        <translation>完了、読戻し一致</translation>
    </message>
    <message numerus="yes">
        <source>done, the controller reformatted %n line(s)</source>
        <translation>
            <numerusform>完了、コントローラが%n行の書式を変更</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ read back different</source>
        <translation>▲ 読戻し不一致</translation>
    </message>
    <message>
        <source>▲ sent, but it could not be read back</source>
        <translation>▲ 送信済み、ただし読み戻せませんでした</translation>
    </message>
    <message>
        <source>← to the computer</source>
        <translation>← コンピュータへ</translation>
    </message>
    <message>
        <source>→ to the controller</source>
        <translation>→ コントローラへ</translation>
    </message>
    <message>
        <source>✕ delete</source>
        <translation>✕ 削除</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/秒</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>バイト数</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>残り</translation>
    </message>
</context>
<context>
    <name>models::TrackModel</name>
    <message>
        <source>Not read at that time.</source>
        <translation>その時刻には読み出していません。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Min in view</source>
        <translation>表示範囲の最小</translation>
    </message>
    <message>
        <source>Max in view</source>
        <translation>表示範囲の最大</translation>
    </message>
</context>
<context>
    <name>models::VariableModel</name>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>前回</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>変更時刻</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>%1 (local)</source>
        <translation>%1 (ローカル)</translation>
    </message>
    <message>
        <source>wrote %1, reads %2</source>
        <translation>書込み %1、読出し %2</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <comment>old and new value</comment>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>未送信</translation>
    </message>
    <message>
        <source>not sent: %1</source>
        <translation>未送信: %1</translation>
    </message>
    <message>
        <source>being written…</source>
        <translation>書込み中…</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>拒否: %1</translation>
    </message>
    <message>
        <source>outcome unknown, look at the robot: %1</source>
        <translation>結果不明、ロボットを確認してください: %1</translation>
    </message>
    <message>
        <source>accepted, but another value was read back</source>
        <translation>受け付けられましたが、別の値が読み戻されました</translation>
    </message>
    <message>
        <source>The controller calls it “%1”.</source>
        <translation>コントローラでの名称は「%1」です。</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>B007, value: 17</comment>
        <translation>%1、%2: %3</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>(empty)</source>
        <translation>(空)</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>読出し %1</translation>
    </message>
    <message>
        <source>→ %1</source>
        <comment>new value</comment>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒否</translation>
    </message>
</context>
<context>
    <name>models::WatchModel</name>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>In jobs</source>
        <translation>ジョブでの使用</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Rising edges</source>
        <translation>立上り</translation>
    </message>
    <message>
        <source>Falling edges</source>
        <translation>立下り</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>変更時刻</translation>
    </message>
</context>
<context>
    <name>motion::JogStep</name>
    <message>
        <source>A step must be above 0 and at most %1 pulses.</source>
        <translation>ステップは0より大きく、%1パルス以下にしてください。</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1 mm.</source>
        <translation>ステップは0より大きく、%1 mm以下にしてください。</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1°.</source>
        <translation>ステップは0より大きく、%1°以下にしてください。</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>現在位置を読み出していません。</translation>
    </message>
    <message>
        <source>The group has no such axis.</source>
        <translation>このグループにその軸はありません。</translation>
    </message>
</context>
<context>
    <name>motion::Plan</name>
    <message>
        <source>The speed must be above 0 and at most %1 mm/s.</source>
        <translation>速度は0より大きく、%1 mm/s以下にしてください。</translation>
    </message>
    <message>
        <source>The rotation speed must be above 0 and at most %1 °/s.</source>
        <translation>回転速度は0より大きく、%1 °/s以下にしてください。</translation>
    </message>
    <message>
        <source>The joint speed must be above 0 and at most %1 %.</source>
        <translation>関節速度は0より大きく、%1 %以下にしてください。</translation>
    </message>
    <message>
        <source>Where this frame stands cannot be read over HSES, so nobody here knows how far the move would go: use the base frame or an increment.</source>
        <translation>この座標の位置はHSESでは読み出せないため、移動がどこまで及ぶかはここでは分かりません。ベース座標または増分を使ってください。</translation>
    </message>
    <message>
        <source>This robot stands on base axes, and HSES does not tell where they are in mm: enter where they shall be.</source>
        <translation>このロボットはベース軸の上にあり、HSESはベース軸のmm単位の位置を知らせません。ベース軸の移動先の位置を入力してください。</translation>
    </message>
    <message>
        <source>The position has no six axes.</source>
        <translation>この位置には6軸の値がありません。</translation>
    </message>
    <message>
        <source>The tool point stands outside the box of this controller.</source>
        <translation>制御点がこのコントローラの許容範囲の外にあります。</translation>
    </message>
    <message>
        <source>The move would leave the box of this controller.</source>
        <translation>この移動はコントローラの許容範囲の外に出ます。</translation>
    </message>
    <message>
        <source>User and tool frames are off until the profile says that they were checked on the robot.</source>
        <translation>ユーザ座標とツール座標は、ロボットで確認済みとプロファイルで指定するまで使えません。</translation>
    </message>
    <message>
        <source>The user frame must be from 1 to 63.</source>
        <translation>ユーザ座標は1から63までにしてください。</translation>
    </message>
    <message>
        <source>The tool must be from 0 to 63.</source>
        <translation>ツールは0から63までにしてください。</translation>
    </message>
    <message>
        <source>A base or a station is moved in pulses.</source>
        <translation>ベースまたはステーションはパルスで移動します。</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>現在位置を読み出していません。</translation>
    </message>
    <message>
        <source>A target in pulses can only be reached by a joint move: how far the tool point would go, and so how fast, is not known here.</source>
        <translation>パルスの目標には関節動作でしか移動できません。制御点がどれだけ動くか、したがってどの速さで動くかは、ここでは分かりません。</translation>
    </message>
    <message>
        <source>This controller has a box, and where pulses lead is not known here: use the base frame.</source>
        <translation>このコントローラには許容範囲があり、パルスでどこへ動くかはここでは分かりません。ベース座標を使ってください。</translation>
    </message>
</context>
<context>
    <name>names::Sentences</name>
    <message>
        <source>%1 has no signal #%2.</source>
        <translation>%1に信号#%2はありません。</translation>
    </message>
    <message>
        <source>There is no #%1: the last digit of a signal is 0 to 7.</source>
        <translation>#%1はありません。信号の最後の桁は0から7までです。</translation>
    </message>
    <message>
        <source>There is no %1#(%2): this controller has %1#(1) to %1#(%3).</source>
        <translation>%1#(%2)はありません。このコントローラには%1#(1)から%1#(%3)まであります。</translation>
    </message>
    <message>
        <source>“%1” is not a signal. Write #00010, IN#(1) or OT#(1).</source>
        <translation>「%1」は信号ではありません。#00010、IN#(1)、OT#(1)のように書いてください。</translation>
    </message>
</context>
<context>
    <name>pages::ActiveAlarmsCard</name>
    <message>
        <source>Active alarms</source>
        <translation>発生中のアラーム</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>すべて確認</translation>
    </message>
    <message>
        <source>Acknowledging is noted on this computer only. The robot does not hear of it.</source>
        <translation>確認はこのコンピュータだけに記録します。ロボットには伝わりません。</translation>
    </message>
    <message>
        <source>Choose one or more alarms in the table first.</source>
        <translation>先に表でアラームを1つ以上選んでください。</translation>
    </message>
    <message>
        <source>Whether there is an alarm is not known now.</source>
        <translation>アラームがあるかどうか、現在は不明です。</translation>
    </message>
    <message>
        <source>There is no alarm to clear.</source>
        <translation>解除するアラームはありません。</translation>
    </message>
    <message>
        <source>Clears the alarms whose causes are gone.</source>
        <translation>原因がなくなったアラームを解除します。</translation>
    </message>
    <message>
        <source>Clears, if the cause is gone: %1.</source>
        <translation>原因がなくなっていれば解除します: %1。</translation>
    </message>
    <message>
        <source>Whether there is an error is not known now.</source>
        <translation>エラーがあるかどうか、現在は不明です。</translation>
    </message>
    <message>
        <source>Clears the error message at the pendant, and no alarm.</source>
        <translation>ペンダントのエラーメッセージを解除します。アラームは解除しません。</translation>
    </message>
    <message>
        <source>There is no error to clear.</source>
        <translation>解除するエラーはありません。</translation>
    </message>
    <message>
        <source>Not connected: nothing is known of the active alarms.</source>
        <translation>未接続のため、発生中のアラームは不明です。</translation>
    </message>
    <message>
        <source>The alarms have not been read yet.</source>
        <translation>アラームはまだ読み出していません。</translation>
    </message>
    <message>
        <source>The controller does not tell its alarms.</source>
        <translation>コントローラはアラームを知らせません。</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active when last seen.</source>
        <translation>
            <numerusform>最終確認時に%n件のアラームが発生していました。</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>発生中のアラームはありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active, the newest first.</source>
        <translation>
            <numerusform>%n件のアラームが発生中です (新しい順)。</numerusform>
        </translation>
    </message>
    <message>
        <source>Reset accepted. Reading the alarms…</source>
        <translation>リセットが受け付けられました。アラームを読み出しています…</translation>
    </message>
    <message>
        <source>Reset accepted. Whether an alarm is left is not known: the status cannot be read.</source>
        <translation>リセットが受け付けられました。状態を読み出せないため、アラームが残っているかどうかは不明です。</translation>
    </message>
    <message>
        <source>Reset accepted. No alarm is active any more.</source>
        <translation>リセットが受け付けられました。発生中のアラームはなくなりました。</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first.</source>
        <translation>▲ 受け付けられましたが、まだ発生中です。先に原因を取り除いてください。</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first. Left are: %1.</source>
        <translation>▲ 受け付けられましたが、まだ発生中です。先に原因を取り除いてください。残り: %1。</translation>
    </message>
    <message>
        <source>Cancel error accepted.</source>
        <translation>エラーキャンセルが受け付けられました。</translation>
    </message>
</context>
<context>
    <name>pages::AlarmHistoryCard</name>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Past alarms</source>
        <translation>過去のアラーム</translation>
    </message>
    <message>
        <source>Most frequent</source>
        <translation>発生頻度順</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>List</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>All lists</source>
        <translation>すべてのリスト</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search code, text or time</source>
        <translation>コード、内容、時刻を検索</translation>
    </message>
    <message>
        <source>Most frequent alarms</source>
        <translation>発生頻度の高いアラーム</translation>
    </message>
    <message>
        <source>Counted in everything this journal has of the controller. The times between are by the controller&apos;s clock; steps of that clock are left out.</source>
        <translation>このコントローラについて操作履歴にあるすべてを数えています。間隔はコントローラの時計によります。時計が変更された部分は除いています。</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>%1のメモ</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>読出しを中止</translation>
    </message>
    <message>
        <source>Read now</source>
        <translation>今すぐ読出し</translation>
    </message>
    <message numerus="yes">
        <source>Reading the history from the controller: %n entry(s) read.</source>
        <translation>
            <numerusform>コントローラから履歴を読み出しています: %n件読出し済み。</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>操作履歴を読み出せません: %1。</translation>
    </message>
    <message numerus="yes">
        <source>Reading was stopped. %n entry(s) in the journal.</source>
        <translation>
            <numerusform>読出しを中止しました。操作履歴に%n件あります。</numerusform>
        </translation>
    </message>
    <message>
        <source>The history could not be read to its end: %1.</source>
        <translation>履歴を最後まで読み出せませんでした: %1。</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n entry(s) of the journal; the export has all of them.</source>
        <translation>
            <numerusform>操作履歴の最新%n件です。エクスポートには全件が含まれます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) in the journal, kept for ever.</source>
        <translation>
            <numerusform>操作履歴に%n件あり、無期限に保存します。</numerusform>
        </translation>
    </message>
    <message>
        <source>Export past alarms</source>
        <translation>過去のアラームをエクスポート</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) exported.</source>
        <translation>
            <numerusform>%n件をエクスポートしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>エクスポートしていません: %1。</translation>
    </message>
</context>
<context>
    <name>pages::AlarmNotes</name>
    <message>
        <source>Save note</source>
        <translation>メモを保存</translation>
    </message>
    <message>
        <source>Export notes…</source>
        <translation>メモをエクスポート…</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) exported.</source>
        <translation>
            <numerusform>%n件のメモをエクスポートしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>エクスポートしていません: %1。</translation>
    </message>
    <message>
        <source>Export notes</source>
        <translation>メモをエクスポート</translation>
    </message>
    <message>
        <source>Codes with a note</source>
        <translation>メモのあるコード</translation>
    </message>
    <message>
        <source>Alarm code</source>
        <translation>アラームコード</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>What we did</source>
        <translation>処置内容</translation>
    </message>
    <message>
        <source>The notes cannot be read: %1.</source>
        <translation>メモを読み出せません: %1。</translation>
    </message>
    <message>
        <source>No note yet.</source>
        <translation>まだメモはありません。</translation>
    </message>
    <message>
        <source>Last changed by %1, %2.</source>
        <translation>最終変更: %1、%2。</translation>
    </message>
</context>
<context>
    <name>pages::AxesCard</name>
    <message>
        <source>pulses</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>following error, pulses</source>
        <translation>位置偏差、パルス</translation>
    </message>
    <message>
        <source>torque, raw</source>
        <translation>トルク、生値</translation>
    </message>
    <message>
        <source>As the controller sends it: the unit is stated nowhere.</source>
        <translation>コントローラが送ったままの値です。単位はどこにも示されていません。</translation>
    </message>
    <message>
        <source>encoder, °C</source>
        <translation>エンコーダ、°C</translation>
    </message>
    <message>
        <source>min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C</source>
        <translation>コンバータ %1: %2 °C</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C, last seen %3</source>
        <translation>コンバータ %1: %2 °C、最終確認 %3</translation>
    </message>
    <message>
        <source>Converter temperature: %1</source>
        <translation>コンバータ温度: %1</translation>
    </message>
</context>
<context>
    <name>pages::BackupPage</name>
    <message>
        <source>Backups</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source> newest</source>
        <translation> 個 (新しい順)</translation>
    </message>
    <message>
        <source>Keep any number</source>
        <translation>個数の制限なし</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 日</translation>
    </message>
    <message>
        <source>Keep any age</source>
        <translation>期間の制限なし</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>今すぐバックアップ</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message numerus="yes">
        <source>Good: every byte of %n file(s) is as it was written.</source>
        <translation>
            <numerusform>良好: %n個のファイルの全バイトが書き込んだときのままです。</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ Not good: %1</source>
        <translation>▲ 不良: %1</translation>
    </message>
    <message>
        <source>After a backup keep</source>
        <translation>バックアップ後に残す範囲</translation>
    </message>
    <message>
        <source>The last good backup and pinned ones are never deleted.</source>
        <translation>最後の良好なバックアップと固定したバックアップは削除しません。</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比較対象</translation>
    </message>
    <message>
        <source>with the backup before</source>
        <translation>1つ前のバックアップと</translation>
    </message>
    <message>
        <source>with the newest backup</source>
        <translation>最新のバックアップと</translation>
    </message>
    <message>
        <source>with the controller now</source>
        <translation>コントローラの現在の内容と</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>復元…</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>保存先: %1</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>固定を解除</translation>
    </message>
    <message>
        <source>Choose a backup first.</source>
        <translation>先にバックアップを選んでください。</translation>
    </message>
    <message>
        <source>Files are being read.</source>
        <translation>ファイルを読み出しています。</translation>
    </message>
    <message>
        <source>Reading file %1 of %2…</source>
        <translation>ファイルを読み出しています (%1 / %2)…</translation>
    </message>
    <message>
        <source>Reading the lists…</source>
        <translation>一覧を読み出しています…</translation>
    </message>
    <message>
        <source>▲ There is no new backup: %1</source>
        <translation>▲ 新しいバックアップはありません: %1</translation>
    </message>
    <message>
        <source>▲ %1 of %2 files were backed up.</source>
        <translation>▲ %2個のうち%1個のファイルをバックアップしました。</translation>
    </message>
    <message numerus="yes">
        <source>All %n file(s) were backed up.</source>
        <translation>
            <numerusform>%n個のファイルをすべてバックアップしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading every byte…</source>
        <translation>全バイトを読んでいます…</translation>
    </message>
    <message>
        <source>There is no other backup to compare with.</source>
        <translation>比較できるバックアップがほかにありません。</translation>
    </message>
    <message>
        <source>The controller&apos;s files were read.</source>
        <translation>コントローラのファイルを読み出しました。</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダ…</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>バックアップのフォルダ</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Exported.</source>
        <translation>エクスポートしました。</translation>
    </message>
    <message>
        <source>▲ Not exported: %1</source>
        <translation>▲ エクスポートできませんでした: %1</translation>
    </message>
    <message>
        <source>Export the backup</source>
        <translation>バックアップのエクスポート</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Zip ファイル (*.zip)</translation>
    </message>
    <message>
        <source>Exporting to %1…</source>
        <translation>%1 にエクスポートしています…</translation>
    </message>
    <message>
        <source>the controller now</source>
        <translation>コントローラの現在の内容</translation>
    </message>
</context>
<context>
    <name>pages::CartesianCard</name>
    <message>
        <source>now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>制御点</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形態</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>拡張形態</translation>
    </message>
    <message>
        <source>%1 · base frame, tool %2</source>
        <translation>%1 · ベース座標、ツール %2</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · ベース座標</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1に制御点はありません。HSESが知らせるのはロボットの制御点だけです。</translation>
    </message>
    <message>
        <source>%1, base frame, tool %2</source>
        <translation>%1、ベース座標、ツール %2</translation>
    </message>
</context>
<context>
    <name>pages::ComparisonCard</name>
    <message>
        <source>≠ changed</source>
        <translation>≠ 変更あり</translation>
    </message>
    <message>
        <source>+ new</source>
        <translation>+ 新規</translation>
    </message>
    <message>
        <source>− gone</source>
        <translation>− 削除</translation>
    </message>
    <message>
        <source>▲ not read, nobody knows</source>
        <translation>▲ 未読出し、不明</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比較結果</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Files that differ</source>
        <translation>異なるファイル</translation>
    </message>
    <message>
        <source>Choose a backup and compare it.</source>
        <translation>バックアップを選んで比較してください。</translation>
    </message>
    <message>
        <source>Not counted as a difference:</source>
        <translation>差異として数えないもの:</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ</source>
        <translation>
            <numerusform>%n個のファイルが異なります</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a file above.</source>
        <translation>上でファイルを選んでください。</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>違いはありません。</translation>
    </message>
    <message>
        <source>This file is not in the backup as it was written.</source>
        <translation>バックアップにあるこのファイルは、書き込んだときと異なります。</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>対象外</translation>
    </message>
    <message>
        <source>Comparison: from %1 to %2</source>
        <translation>比較結果: %1から%2へ</translation>
    </message>
    <message>
        <source>The files are being compared…</source>
        <translation>ファイルを比較しています…</translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %n counter(s), log(s) and the like</source>
        <translation>
            <numerusform>対象外: カウンタ、ログなど%n件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::CycleCard</name>
    <message>
        <source>Cycle</source>
        <translation>サイクル</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>実際</translation>
    </message>
    <message>
        <source>Requested here</source>
        <translation>ここからの要求</translation>
    </message>
    <message>
        <source>Nothing was requested from here.</source>
        <translation>ここからは何も要求していません。</translation>
    </message>
    <message>
        <source>Cycle mode to request</source>
        <translation>要求するサイクルモード</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>要求</translation>
    </message>
</context>
<context>
    <name>pages::FilePane</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n個のファイル</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FilesPage</name>
    <message>
        <source>This computer</source>
        <translation>このコンピュータ</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>再読出し</translation>
    </message>
    <message>
        <source>← Fetch</source>
        <translation>← 取得</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>編集…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダ…</translation>
    </message>
    <message>
        <source>Folder of the files</source>
        <translation>ファイルのフォルダ</translation>
    </message>
    <message>
        <source>Type of the files</source>
        <translation>ファイルのタイプ</translation>
    </message>
    <message>
        <source>Send →</source>
        <translation>送信 →</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>削除…</translation>
    </message>
    <message>
        <source>There are no controller files in this folder.</source>
        <translation>このフォルダにコントローラのファイルはありません。</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>一覧を読み出しています…</translation>
    </message>
    <message>
        <source>The controller lists no files of this type.</source>
        <translation>コントローラの一覧にこのタイプのファイルはありません。</translation>
    </message>
    <message>
        <source>Choose files on the left first.</source>
        <translation>先に左側でファイルを選んでください。</translation>
    </message>
    <message>
        <source>Choose files on the right first.</source>
        <translation>先に右側でファイルを選んでください。</translation>
    </message>
</context>
<context>
    <name>pages::FleetPage</name>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Size of the tiles</source>
        <translation>タイルの大きさ</translation>
    </message>
    <message>
        <source>HOLD ALL</source>
        <translation>全台HOLD</translation>
    </message>
    <message>
        <source>HOLD all controllers (software)</source>
        <translation>すべてのコントローラをHOLD (ソフトウェア)</translation>
    </message>
    <message>
        <source>every station that is not off</source>
        <translation>オフではないすべてのコントローラ</translation>
    </message>
    <message>
        <source>Connect all</source>
        <translation>全台接続</translation>
    </message>
    <message>
        <source>Back up all</source>
        <translation>全台バックアップ</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>絞り込み</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>ボード</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>S</source>
        <translation>小</translation>
    </message>
    <message>
        <source>M</source>
        <translation>中</translation>
    </message>
    <message>
        <source>L</source>
        <translation>大</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>コントローラ</translation>
    </message>
    <message numerus="yes">
        <source>%n controller(s)</source>
        <translation>
            <numerusform>コントローラ%n台</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>接続中 %n台</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without link</source>
        <translation>
            <numerusform>リンクなし %n台</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n station(s) that are not off</source>
        <translation>
            <numerusform>オフではないコントローラ %n台</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ HOLD was not confirmed by %1: look at the robot.</source>
        <translation>▲ %1のHOLDを確認できませんでした。ロボットを確認してください。</translation>
    </message>
    <message>
        <source>HOLD is being asked of %1.</source>
        <translation>%1にHOLDを要求しています。</translation>
    </message>
    <message numerus="yes">
        <source>HOLD was confirmed by %n controller(s).</source>
        <translation>
            <numerusform>%n台のコントローラでHOLDを確認しました。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::GroupCard</name>
    <message>
        <source>axis %1</source>
        <translation>軸%1</translation>
    </message>
</context>
<context>
    <name>pages::HoldCard</name>
    <message>
        <source>Hold</source>
        <translation>ホールド</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>ホールド元</translation>
    </message>
</context>
<context>
    <name>pages::IoPage</name>
    <message>
        <source>User in</source>
        <translation>汎用入力</translation>
    </message>
    <message>
        <source>User out</source>
        <translation>汎用出力</translation>
    </message>
    <message>
        <source>External in</source>
        <translation>外部入力</translation>
    </message>
    <message>
        <source>Network in</source>
        <translation>ネットワーク入力</translation>
    </message>
    <message>
        <source>External out</source>
        <translation>外部出力</translation>
    </message>
    <message>
        <source>Network out</source>
        <translation>ネットワーク出力</translation>
    </message>
    <message>
        <source>System in</source>
        <translation>専用入力</translation>
    </message>
    <message>
        <source>System out</source>
        <translation>専用出力</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>Relays</source>
        <translation>補助リレー</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>制御状態</translation>
    </message>
    <message>
        <source>Pseudo in</source>
        <translation>疑似入力</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>0から数え直す</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>ウォッチ</translation>
    </message>
    <message>
        <source>Over HSES only network inputs can be written: this lamp only shows.</source>
        <translation>HSESで書き込めるのはネットワーク入力だけです。このランプは表示専用です。</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>書込み…</translation>
    </message>
    <message>
        <source>Name it here…</source>
        <translation>ここで名称を付ける…</translation>
    </message>
    <message>
        <source>Take the local name away</source>
        <translation>ローカルの名称を外す</translation>
    </message>
    <message>
        <source>Watch no longer</source>
        <translation>ウォッチをやめる</translation>
    </message>
    <message>
        <source>Copy the address</source>
        <translation>アドレスをコピー</translation>
    </message>
    <message>
        <source>Edges are counted from what is read four times a second; shorter pulses are not seen.</source>
        <translation>エッジは毎秒4回の読出しから数えます。それより短いパルスは検出しません。</translation>
    </message>
    <message>
        <source>Network inputs can be written: press Enter on a lamp.</source>
        <translation>ネットワーク入力は書き込めます。ランプの上でEnterを押してください。</translation>
    </message>
    <message>
        <source>These lamps only show: over HSES only network inputs can be written.</source>
        <translation>これらのランプは表示専用です。HSESで書き込めるのはネットワーク入力だけです。</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) from %1 on are refused: %2.</source>
        <translation>
            <numerusform>%1からの%nグループは拒否されました: %2。</numerusform>
        </translation>
    </message>
    <message>
        <source>The controller&apos;s names are not known: %1.</source>
        <translation>コントローラの名称は不明です: %1。</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) of IONAME.DAT could not be read.</source>
        <translation>
            <numerusform>IONAME.DATの%n行を読み取れませんでした。</numerusform>
        </translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Area of signals</source>
        <translation>信号の範囲</translation>
    </message>
    <message>
        <source>Watched signals</source>
        <translation>ウォッチ中の信号</translation>
    </message>
</context>
<context>
    <name>pages::JobCard</name>
    <message>
        <source>master task</source>
        <translation>マスタタスク</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>速度オーバーライド</translation>
    </message>
</context>
<context>
    <name>pages::JobListCard</name>
    <message>
        <source>Jobs on the controller</source>
        <translation>コントローラのジョブ</translation>
    </message>
    <message>
        <source>★ Favourite</source>
        <translation>★ お気に入り</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>再読出し</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>絞り込み</translation>
    </message>
    <message>
        <source>Filter jobs by name</source>
        <translation>ジョブ名で絞り込み</translation>
    </message>
    <message>
        <source>The list could not be read: %1.</source>
        <translation>一覧を読み出せませんでした: %1。</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>一覧を読み出しています…</translation>
    </message>
    <message>
        <source>The list was not read yet.</source>
        <translation>一覧はまだ読み出していません。</translation>
    </message>
    <message>
        <source>There is no job on the controller.</source>
        <translation>コントローラにジョブがありません。</translation>
    </message>
    <message>
        <source>No job has “%1” in its name.</source>
        <translation>名前に「%1」を含むジョブはありません。</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>読出し中…</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s)</source>
        <translation>
            <numerusform>%n個のジョブ</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, read at %2</source>
        <translation>%1、%2に読出し</translation>
    </message>
</context>
<context>
    <name>pages::JobTextCard</name>
    <message>
        <source>Job text</source>
        <translation>ジョブの内容</translation>
    </message>
    <message>
        <source>Choose a job in the list to read it.</source>
        <translation>読み出すジョブを一覧から選んでください。</translation>
    </message>
    <message>
        <source>Follow what is executed</source>
        <translation>実行行を追従</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>再読出し</translation>
    </message>
    <message>
        <source>Labels and calls</source>
        <translation>ラベルと呼出し</translation>
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
        <translation>読出し中…</translation>
    </message>
    <message>
        <source>read at %1</source>
        <translation>%1に読出し</translation>
    </message>
    <message>
        <source>The job could not be read: %1.</source>
        <translation>ジョブを読み出せませんでした: %1。</translation>
    </message>
    <message>
        <source>Read at %1. The controller was in TEACH or the link was lost since: this copy may be old.</source>
        <translation>%1に読出し。その後コントローラがTEACHになったか通信が途絶したため、この写しは古い可能性があります。</translation>
    </message>
    <message>
        <source>Reading the job…</source>
        <translation>ジョブを読み出しています…</translation>
    </message>
    <message>
        <source>The job was not read yet.</source>
        <translation>ジョブはまだ読み出していません。</translation>
    </message>
    <message>
        <source>This file holds no instructions that could be shown.</source>
        <translation>このファイルには、表示できる命令がありません。</translation>
    </message>
</context>
<context>
    <name>pages::JobsPage</name>
    <message>
        <source>Orders</source>
        <translation>指令</translation>
    </message>
</context>
<context>
    <name>pages::JogCard</name>
    <message>
        <source>Jog</source>
        <translation>ジョグ</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>座標</translation>
    </message>
    <message>
        <source>Keyboard too: hold Ctrl and Space on the button that has the focus</source>
        <translation>キーボードも使う: フォーカスのあるボタンでCtrlとSpaceを押し続ける</translation>
    </message>
    <message>
        <source>Hold a button: one bounded step after another</source>
        <translation>ボタンを押し続ける: 範囲を限ったステップを1つずつ続けて実行</translation>
    </message>
    <message>
        <source>After a lost link</source>
        <translation>通信途絶後</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>最後のステップ</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>ベース</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>Axes (pulses)</source>
        <translation>軸 (パルス)</translation>
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
        <translation>最大1ステップ: %1パルス</translation>
    </message>
    <message>
        <source>at most one step: %1 mm or %2°, in %3 s at most</source>
        <translation>最大1ステップ: %1 mmまたは%2°、最長%3 秒</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>オフ: プロファイルに、0より大きい数ではない動作の制限値があります (%1)。</translation>
    </message>
    <message>
        <source>No answer to the step: whether it was taken is unknown. HOLD was sent. Look at the robot.</source>
        <translation>ステップへの応答がありません。実行されたかどうかは不明です。HOLDを送信しました。ロボットを確認してください。</translation>
    </message>
    <message>
        <source>Step sent…</source>
        <translation>ステップを送信しました…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>移動中…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at rest.</source>
        <translation>
            <numerusform>%nステップ、静止しています。</numerusform>
        </translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>まだありません。</translation>
    </message>
</context>
<context>
    <name>pages::JournalPage</name>
    <message>
        <source>At any time</source>
        <translation>全期間</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>今日</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>過去7日間</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>過去30日間</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>操作履歴</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>All controllers</source>
        <translation>すべてのコントローラ</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Any outcome</source>
        <translation>すべての結果</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search in all texts</source>
        <translation>すべての文字列を検索</translation>
    </message>
    <message>
        <source>Reading the journal…</source>
        <translation>操作履歴を読み出しています…</translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>操作履歴を読み出せません: %1。</translation>
    </message>
    <message>
        <source>Nothing was tried that fits this filter.</source>
        <translation>この絞り込みに合う操作はありません。</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n record(s). Scroll down for older ones.</source>
        <translation>
            <numerusform>最新の%n件です。古い記録は下へスクロールしてください。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n件の記録</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a record to read all of it here.</source>
        <translation>記録を選ぶと、全文をここに表示します。</translation>
    </message>
    <message>
        <source>%1: %2 at %3.</source>
        <translation>%1: %2 (%3)。</translation>
    </message>
    <message>
        <source>Outcome: %1.</source>
        <translation>結果: %1。</translation>
    </message>
    <message>
        <source>By %1 at %2, level %3.</source>
        <translation>実行者: %1 (%2)、レベル: %3。</translation>
    </message>
    <message>
        <source>Export the journal</source>
        <translation>操作履歴をエクスポート</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) exported.</source>
        <translation>
            <numerusform>%n件の記録をエクスポートしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>エクスポートしていません: %1。</translation>
    </message>
</context>
<context>
    <name>pages::LinkCard</name>
    <message>
        <source>%1 repeated</source>
        <translation>再送 %1</translation>
    </message>
    <message>
        <source>%1 unanswered</source>
        <translation>無応答 %1</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>遅延 %1</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>重複 %1</translation>
    </message>
    <message>
        <source>%1 mismatched</source>
        <translation>不一致 %1</translation>
    </message>
    <message>
        <source>%1 malformed</source>
        <translation>形式不正 %1</translation>
    </message>
    <message>
        <source>%1 from elsewhere</source>
        <translation>別の送信元 %1</translation>
    </message>
    <message>
        <source>%1 busy</source>
        <translation>ビジー %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>直近60秒</translation>
    </message>
    <message>
        <source>round trip p50 / p95</source>
        <translation>往復時間 p50 / p95</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>消失</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>last answer</source>
        <translation>最後の応答</translation>
    </message>
    <message>
        <source>sent / answered</source>
        <translation>送信 / 応答</translation>
    </message>
    <message>
        <source>unusual</source>
        <translation>異常</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 /s of %2</source>
        <translation>%1 /秒 (上限 %2)</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1前</translation>
    </message>
</context>
<context>
    <name>pages::MotionPage</name>
    <message>
        <source>Remote motion in automatic operation. The pendant’s enabling switch does not protect anyone here. Nobody may be inside the fence.</source>
        <translation>自動運転での遠隔動作です。ここではペンダントのイネーブルスイッチは誰も保護しません。安全柵の中に人がいてはいけません。</translation>
    </message>
    <message>
        <source>Before each step</source>
        <translation>各ステップの前に</translation>
    </message>
    <message>
        <source>Control group that moves</source>
        <translation>動かす制御グループ</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>制御グループ</translation>
    </message>
</context>
<context>
    <name>pages::MoveCard</name>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Type of the move</source>
        <translation>移動の種類</translation>
    </message>
    <message>
        <source>Frame of the target</source>
        <translation>目標の座標</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>ユーザ座標</translation>
    </message>
    <message>
        <source>Base axes in mm</source>
        <translation>ベース軸 (mm)</translation>
    </message>
    <message>
        <source>Rehearse…</source>
        <translation>事前確認…</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>関節動作</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>直線動作</translation>
    </message>
    <message>
        <source>Straight, increment</source>
        <translation>直線動作、増分</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>ベース座標</translation>
    </message>
    <message>
        <source>Robot frame</source>
        <translation>ロボット座標</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>ツール座標</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>パルス</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>座標</translation>
    </message>
    <message>
        <source>now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>change</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>Speed in mm/s</source>
        <translation>速度 (mm/s)</translation>
    </message>
    <message>
        <source>Rotation speed in °/s</source>
        <translation>回転速度 (°/s)</translation>
    </message>
    <message>
        <source>Joint speed in %</source>
        <translation>関節速度 (%)</translation>
    </message>
    <message>
        <source>mm/s, at most %1</source>
        <translation>mm/s (上限 %1)</translation>
    </message>
    <message>
        <source>°/s, at most %1</source>
        <translation>°/s (上限 %1)</translation>
    </message>
    <message>
        <source>% of joint speed, at most %1</source>
        <translation>関節速度の% (上限 %1)</translation>
    </message>
    <message>
        <source>Target of %1 in %2</source>
        <translation>%1の目標 (%2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There are three base axes at most.</source>
        <translation>ベース軸は最大3軸です。</translation>
    </message>
    <message>
        <source>Base axes: %1</source>
        <translation>ベース軸: %1</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>オフ: プロファイルに、0より大きい数ではない動作の制限値があります (%1)。</translation>
    </message>
    <message>
        <source>Form: %1</source>
        <translation>形態: %1</translation>
    </message>
</context>
<context>
    <name>pages::Offers</name>
    <message>
        <source>Before sending</source>
        <translation>送信の前に</translation>
    </message>
    <message numerus="yes">
        <source>Send %n file(s)</source>
        <translation>
            <numerusform>%n個のファイルを送信</numerusform>
        </translation>
    </message>
    <message>
        <source>on this computer</source>
        <translation>このコンピュータ上</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>%1上</translation>
    </message>
    <message>
        <source>What would change in “%1”</source>
        <translation>「%1」で変わる内容</translation>
    </message>
</context>
<context>
    <name>pages::OptionsCard</name>
    <message>
        <source>always: the button above, the Pause key or Ctrl+Shift+H.</source>
        <translation>いつでも: 上のボタン、Pauseキー、またはCtrl+Shift+H。</translation>
    </message>
    <message>
        <source>sent repeatedly until confirmed or 2 s have passed. Have the pendant at hand.</source>
        <translation>確認されるか2秒が過ぎるまで、繰り返し送信します。ペンダントを手元に置いてください。</translation>
    </message>
    <message>
        <source>there is no connection: use the pendant.</source>
        <translation>接続していません。ペンダントを使ってください。</translation>
    </message>
    <message>
        <source>What can I do now?</source>
        <translation>今できること</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>possible</source>
        <translation>可能</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>不可</translation>
    </message>
</context>
<context>
    <name>pages::PendantCard</name>
    <message>
        <source>Pendant</source>
        <translation>ペンダント</translation>
    </message>
    <message>
        <source>Message for the pendant</source>
        <translation>ペンダントへのメッセージ</translation>
    </message>
    <message>
        <source>Show on the pendant</source>
        <translation>ペンダントに表示</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n byte(s)</source>
        <translation>
            <numerusform>%1 / %nバイト</numerusform>
        </translation>
    </message>
    <message>
        <source>Type a message first.</source>
        <translation>先にメッセージを入力してください。</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding cannot hold this: %1.</source>
        <translation>コントローラの文字コードでは表せません: %1。</translation>
    </message>
    <message>
        <source>The message is too long for the pendant.</source>
        <translation>メッセージがペンダントには長すぎます。</translation>
    </message>
    <message>
        <source>HLOCK was switched on from here: the pendant is locked out, but for its emergency stop.</source>
        <translation>ここからHLOCKをオンにしました。ペンダントは非常停止を除いて操作できません。</translation>
    </message>
    <message>
        <source>HLOCK locks the pendant out. Whether it is on cannot be read over HSES; from here it was not switched on.</source>
        <translation>HLOCKはペンダントの操作を禁止します。オンかどうかはHSESでは読み出せません。ここからはオンにしていません。</translation>
    </message>
</context>
<context>
    <name>pages::PointsBar</name>
    <message>
        <source>Take the present position</source>
        <translation>現在位置を取込み</translation>
    </message>
    <message>
        <source>Take P</source>
        <translation>Pを取込み</translation>
    </message>
    <message>
        <source>Earlier places</source>
        <translation>以前の位置</translation>
    </message>
    <message>
        <source>Keep the present position as P</source>
        <translation>現在位置をPに保存</translation>
    </message>
    <message>
        <source>P variable</source>
        <translation>P変数</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>%1を読み出しています…</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>%1を読み出せませんでした: %2。</translation>
    </message>
    <message>
        <source>%1 is in another frame (%2): choose that frame and an absolute move to take it.</source>
        <translation>%1は別の座標 (%2) です。取り込むには、その座標と増分ではない移動を選んでください。</translation>
    </message>
    <message>
        <source>The target is %1.</source>
        <translation>目標は%1です。</translation>
    </message>
    <message>
        <source>Only the present position of a robot can be kept, once it was read.</source>
        <translation>保存できるのは、読み出した後のロボットの現在位置だけです。</translation>
    </message>
    <message>
        <source>%1 was written and read back.</source>
        <translation>%1を書き込み、読み戻しました。</translation>
    </message>
    <message>
        <source>%1 was not verified: %2.</source>
        <translation>%1は照合できていません: %2。</translation>
    </message>
    <message>
        <source>%1 was written, but another value was read back.</source>
        <translation>%1を書き込みましたが、別の値が読み戻されました。</translation>
    </message>
    <message>
        <source>No move has begun in this frame yet</source>
        <translation>この座標で始めた移動はまだありません</translation>
    </message>
    <message>
        <source>%1 is not taught.</source>
        <translation>%1は教示されていません。</translation>
    </message>
    <message>
        <source>Other values are still being written.</source>
        <translation>まだほかの値を書き込んでいます。</translation>
    </message>
    <message>
        <source>%1 holds this position already.</source>
        <translation>%1はすでにこの位置です。</translation>
    </message>
</context>
<context>
    <name>pages::PositionCard</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>R1 · base frame, tool %1  ·  pulses</source>
        <translation>R1 · ベース座標、ツール %1  ·  パルス</translation>
    </message>
    <message>
        <source>R1 · base frame  ·  pulses</source>
        <translation>R1 · ベース座標  ·  パルス</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>軸%1</translation>
    </message>
</context>
<context>
    <name>pages::PositionPage</name>
    <message>
        <source>Control groups</source>
        <translation>制御グループ</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>最小と最大をリセット</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>テキストとしてコピー</translation>
    </message>
    <message>
        <source>Not shown because refused: %1 of %2 control groups.</source>
        <translation>拒否されたため表示していません: %2個のうち%1個の制御グループ。</translation>
    </message>
    <message numerus="yes">
        <source>%n control group(s)</source>
        <translation>
            <numerusform>制御グループ%n個</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::QueueCard</name>
    <message>
        <source>Transfers</source>
        <translation>転送</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>失敗分を再試行</translation>
    </message>
    <message>
        <source>Clear finished</source>
        <translation>完了分を消去</translation>
    </message>
</context>
<context>
    <name>pages::RegistersPage</name>
    <message>
        <source>How registers are written</source>
        <translation>レジスタの表記</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>10進</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>符号付き</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>16進</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>2進</translation>
    </message>
    <message>
        <source>M000 to M559 can be written; the others belong to the ladder.</source>
        <translation>書き込めるのはM000からM559までです。ほかはラダーが使います。</translation>
    </message>
</context>
<context>
    <name>pages::RemoteChanges</name>
    <message>
        <source>What changes in “%1” on %2</source>
        <translation>%2の「%1」で変わる内容</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>送信</translation>
    </message>
    <message>
        <source>Delete on %1</source>
        <translation>%1のファイル削除</translation>
    </message>
    <message>
        <source>These files are deleted on %1:
%2
Before that each is copied to %3.</source>
        <translation>%1の次のファイルを削除します:
%2
その前に、それぞれを%3にコピーします。</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n file(s)</source>
        <translation>
            <numerusform>%n個のファイルを削除</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::SelectCard</name>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Select as</source>
        <translation>選択方法</translation>
    </message>
    <message>
        <source>to be executed</source>
        <translation>実行ジョブ</translation>
    </message>
    <message>
        <source>master job</source>
        <translation>マスタジョブ</translation>
    </message>
    <message>
        <source>master job of sub task %1</source>
        <translation>サブタスク%1のマスタジョブ</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>開始行</translation>
    </message>
    <message>
        <source>line </source>
        <translation>行 </translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1を選択</translation>
    </message>
    <message>
        <source>Choose a job in the list first.</source>
        <translation>先に一覧でジョブを選んでください。</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1、行 %2</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>タスク%1</translation>
    </message>
</context>
<context>
    <name>pages::SelectionCard</name>
    <message>
        <source>Job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>Where it is</source>
        <translation>現在の位置</translation>
    </message>
    <message>
        <source>master task</source>
        <translation>マスタタスク</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運転</translation>
    </message>
</context>
<context>
    <name>pages::ServoCard</name>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Servo power</source>
        <translation>サーボ電源</translation>
    </message>
    <message>
        <source>A job is running: servo off stops it at once.</source>
        <translation>ジョブが運転中です。サーボオフにすると直ちに停止します。</translation>
    </message>
    <message>
        <source>Servo on…</source>
        <translation>サーボオン…</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>サーボオン</translation>
    </message>
    <message>
        <source>Switch servo power on at %1?

The robot can move from then on. Nobody may be inside the fence.</source>
        <translation>%1のサーボ電源を入れますか?

以後、ロボットが動く可能性があります。安全柵の中に人がいてはいけません。</translation>
    </message>
</context>
<context>
    <name>pages::StartCard</name>
    <message>
        <source>Start</source>
        <translation>起動</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>起動…</translation>
    </message>
</context>
<context>
    <name>pages::StartPanel</name>
    <message>
        <source>Start</source>
        <translation>開始画面</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>未接続</translation>
    </message>
    <message>
        <source>Nothing is read and nothing is shown. Connecting only reads: nothing is written, started or moved by it.</source>
        <translation>何も読み出さず、何も表示していません。接続は読出しだけを行います。接続によって書込み、起動、移動が行われることはありません。</translation>
    </message>
    <message>
        <source>Connect to a controller…</source>
        <translation>コントローラに接続…</translation>
    </message>
    <message>
        <source>A controller in your network</source>
        <translation>ネットワーク上のコントローラ</translation>
    </message>
    <message>
        <source>Enter its name or address. Pendesk checks step by step whether it answers, and says what is wrong where it does not.</source>
        <translation>名前またはアドレスを入力してください。Pendeskは応答するかどうかを段階ごとに確認し、応答しない場合はどこに問題があるかを示します。</translation>
    </message>
    <message>
        <source>No robot at hand</source>
        <translation>手元にロボットがない場合</translation>
    </message>
    <message>
        <source>The demo brings a simulated controller in this program. Everything can be tried with it, and no robot moves.</source>
        <translation>デモには、このプログラム内の模擬コントローラがあります。すべての機能を試せます。ロボットは動きません。</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>デモを開く</translation>
    </message>
    <message>
        <source>Recent controllers</source>
        <translation>最近のコントローラ</translation>
    </message>
    <message>
        <source>Another controller…</source>
        <translation>別のコントローラ…</translation>
    </message>
</context>
<context>
    <name>pages::StateCard</name>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>サイクル</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運転</translation>
    </message>
    <message>
        <source>Hold · pendant</source>
        <translation>ホールド · ペンダント</translation>
    </message>
    <message>
        <source>Hold · external</source>
        <translation>ホールド · 外部</translation>
    </message>
    <message>
        <source>Hold · command</source>
        <translation>ホールド · コマンド</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>速度制限</translation>
    </message>
</context>
<context>
    <name>pages::SystemCard</name>
    <message>
        <source>System</source>
        <translation>システム</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>機種</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>ソフトウェア</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the system information</source>
        <translation>システム情報をコピー</translation>
    </message>
    <message>
        <source>The profile says %1, but this is the software of a %2: correct the profile.</source>
        <translation>プロファイルでは%1ですが、このソフトウェアは%2のものです。プロファイルを修正してください。</translation>
    </message>
</context>
<context>
    <name>pages::TasksCard</name>
    <message>
        <source>Tasks</source>
        <translation>タスク</translation>
    </message>
    <message>
        <source>Show the sub tasks</source>
        <translation>サブタスクを表示</translation>
    </message>
    <message numerus="yes">
        <source>%n sub task(s)</source>
        <translation>
            <numerusform>%n個のサブタスク</numerusform>
        </translation>
    </message>
    <message>
        <source>Sub task %1</source>
        <translation>サブタスク%1</translation>
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
        <translation>動作許可中</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>未接続</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>%1から</translation>
    </message>
    <message>
        <source>last seen: %1</source>
        <translation>最終確認: %1</translation>
    </message>
    <message>
        <source>Servo %1</source>
        <translation>サーボ %1</translation>
    </message>
</context>
<context>
    <name>pages::Timeline</name>
    <message>
        <source>▲ no backup any more</source>
        <translation>▲ もうバックアップではありません</translation>
    </message>
    <message numerus="yes">
        <source>▲ %n file(s) missing</source>
        <translation>
            <numerusform>▲ %n個のファイルがありません</numerusform>
        </translation>
    </message>
    <message>
        <source>complete</source>
        <translation>完全</translation>
    </message>
    <message>
        <source>%1, pinned</source>
        <translation>%1、固定</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>取得日時</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>Changed</source>
        <comment>number of files</comment>
        <translation>変更数</translation>
    </message>
</context>
<context>
    <name>pages::ToolPathCard</name>
    <message>
        <source>Tool path</source>
        <translation>ツール軌跡</translation>
    </message>
    <message>
        <source>Clear path</source>
        <translation>軌跡を消去</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · ベース座標</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1に制御点はありません。HSESが知らせるのはロボットの制御点だけです。</translation>
    </message>
</context>
<context>
    <name>pages::TrendPage</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>Add signal…</source>
        <translation>信号を追加…</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSVエクスポート…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Freezes the view; recording goes on.</source>
        <translation>表示を止めます。記録は続きます。</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>ライブに戻る</translation>
    </message>
    <message>
        <source>Time in view</source>
        <translation>表示時間</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>トレンド</translation>
    </message>
    <message>
        <source>Nothing is plotted yet. Drag a number here from any page, choose “Add to trend” in its menu, or add a signal.</source>
        <translation>まだ何もプロットしていません。任意のページから数値をここへドラッグするか、そのメニューで「トレンドに追加」を選ぶか、信号を追加してください。</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Remove from trend</source>
        <translation>トレンドから外す</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>インシデント</translation>
    </message>
    <message>
        <source>60 s before an alarm, 20 s after</source>
        <translation>アラームの60秒前から20秒後まで</translation>
    </message>
    <message>
        <source>Open incident</source>
        <translation>インシデントを開く</translation>
    </message>
    <message>
        <source>No alarm has been recorded yet.</source>
        <translation>アラームはまだ記録されていません。</translation>
    </message>
    <message>
        <source>It could not be saved: %1</source>
        <translation>保存できませんでした: %1</translation>
    </message>
    <message>
        <source>Incident of %1: %2</source>
        <translation>%1のインシデント: %2</translation>
    </message>
    <message>
        <source>Paused at %1; recording goes on</source>
        <translation>%1に一時停止、記録は継続中</translation>
    </message>
    <message>
        <source>Nothing is recorded: no communication</source>
        <translation>何も記録していません: 通信なし</translation>
    </message>
    <message>
        <source>Live; values of %1</source>
        <translation>ライブ、%1の値</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>ライブ</translation>
    </message>
    <message>
        <source>%1 is refused by the controller.</source>
        <translation>%1はコントローラに拒否されました。</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>This incident cannot be read: %1</source>
        <translation>このインシデントを読み出せません: %1</translation>
    </message>
    <message>
        <source>Export what is in view</source>
        <translation>表示範囲をエクスポート</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSVファイル (*.csv)</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>ファイルに書き込めませんでした: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariableSheet</name>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>直前の書込みを戻す</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>インポート…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>%1 can only be read over HSES.</source>
        <translation>%1はHSESでは読出し専用です。</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>書込み中…</translation>
    </message>
    <message numerus="yes">
        <source>Apply %n…</source>
        <translation>
            <numerusform>%n個を適用…</numerusform>
        </translation>
    </message>
    <message>
        <source>The values are being written.</source>
        <translation>値を書き込んでいます。</translation>
    </message>
    <message>
        <source>Nothing is staged: press Enter in a value.</source>
        <translation>書込み予定の値はありません。値の上でEnterを押してください。</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>書込み予定の値はありません。</translation>
    </message>
    <message>
        <source>Stages the values that stood there before.</source>
        <translation>書込み前の値を書込み予定に追加します。</translation>
    </message>
    <message>
        <source>Nothing was written that could be undone.</source>
        <translation>元に戻せる書込みはありません。</translation>
    </message>
    <message>
        <source>Import values</source>
        <translation>値をインポート</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSVファイル (*.csv)</translation>
    </message>
    <message>
        <source>Export values</source>
        <translation>値をエクスポート</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>レジスタ</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>変数</translation>
    </message>
    <message>
        <source>%1 stays as it is: %2</source>
        <comment>variable: reason</comment>
        <translation>%1 はそのまま残ります: %2</translation>
    </message>
</context>
<context>
    <name>pages::VariableTransfer</name>
    <message>
        <source>%1 was written.</source>
        <translation>%1を書き込みました。</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n variable(s)…</source>
        <translation>
            <numerusform>%n個の変数を読み出しています…</numerusform>
        </translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>ファイルを読み取れません: %1</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>ファイルに書き込めませんでした: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariablesPage</name>
    <message>
        <source>Verify…</source>
        <translation>照合…</translation>
    </message>
    <message>
        <source>Compares two variables with the pendant. It only reads.</source>
        <translation>2つの変数をペンダントと比較します。読出しだけを行います。</translation>
    </message>
    <message>
        <source>New watch page…</source>
        <translation>新しいウォッチページ…</translation>
    </message>
    <message>
        <source>New watch page</source>
        <translation>新しいウォッチページ</translation>
    </message>
    <message>
        <source>Name of the page</source>
        <translation>ページの名前</translation>
    </message>
    <message>
        <source>Watch: %1</source>
        <translation>ウォッチ: %1</translation>
    </message>
    <message>
        <source>Delete this watch page</source>
        <translation>このウォッチページを削除</translation>
    </message>
    <message>
        <source>Show on the watch page “%1”</source>
        <translation>ウォッチページ「%1」に表示</translation>
    </message>
    <message>
        <source>Take off this watch page</source>
        <translation>このウォッチページから外す</translation>
    </message>
    <message>
        <source>There is no watch page yet.</source>
        <translation>ウォッチページはまだありません。</translation>
    </message>
    <message>
        <source>Numbering not verified: nothing is written before it was compared with the pendant.</source>
        <translation>変数番号の方式が未照合です。ペンダントと比較するまで、何も書き込みません。</translation>
    </message>
    <message>
        <source>Simulation: number %1 on the network is B000.</source>
        <translation>シミュレーション: ネットワーク上の番号%1がB000です。</translation>
    </message>
    <message>
        <source>Numbering verified %1: number %2 on the network is B000.</source>
        <translation>変数番号の方式は%1に照合済み: ネットワーク上の番号%2がB000です。</translation>
    </message>
    <message>
        <source>Kind of variable</source>
        <translation>変数の種類</translation>
    </message>
</context>
<context>
    <name>pages::start::RecentTile</name>
    <message>
        <source>no connection noted yet</source>
        <translation>接続の記録なし</translation>
    </message>
    <message>
        <source>connected today %1</source>
        <comment>the time</comment>
        <translation>接続: 今日 %1</translation>
    </message>
    <message>
        <source>connected yesterday %1</source>
        <comment>the time</comment>
        <translation>接続: 昨日 %1</translation>
    </message>
    <message>
        <source>connected %1 %2</source>
        <comment>the date, the time</comment>
        <translation>接続: %1 %2</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>%1に接続</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>シミュレーション</translation>
    </message>
</context>
<context>
    <name>pages::start::SetupCard</name>
    <message>
        <source>What must be set on the pendant</source>
        <translation>ペンダントで必要な設定</translation>
    </message>
    <message>
        <source>Menus differ by model and software</source>
        <translation>メニューは機種とソフトウェアによって異なります</translation>
    </message>
    <message>
        <source>To be found</source>
        <translation>接続できるようにする</translation>
    </message>
    <message>
        <source>The Ethernet server function (HSES) is on; it is an option of DX100, DX200 and FS100. The controller has an IPv4 address in the network of this computer, and no firewall between them drops UDP %1 and %2.</source>
        <translation>Ethernetサーバ機能 (HSES) が有効であること。この機能はDX100、DX200、FS100ではオプションです。コントローラにこのコンピュータと同じネットワークのIPv4アドレスがあり、間のファイアウォールがUDP %1と%2を遮断していないこと。</translation>
    </message>
    <message>
        <source>To take orders</source>
        <translation>指令を受け付けるようにする</translation>
    </message>
    <message>
        <source>Only for starting, moving, resetting and files, not for reading: %1.</source>
        <translation>起動、移動、リセット、ファイルにだけ必要です。読出しには不要です: %1。</translation>
    </message>
    <message>
        <source>To select and replace</source>
        <translation>選択と置換えを許可する</translation>
    </message>
    <message>
        <source>For selecting jobs from here: %1. For replacing files that exist there: %2.</source>
        <translation>ここからジョブを選択する場合: %1。コントローラにあるファイルを置き換える場合: %2。</translation>
    </message>
</context>
<context>
    <name>pendesk</name>
    <message>
        <source>A teach and monitor desk for Yaskawa robot controllers.</source>
        <translation>安川電機のロボットコントローラ用のティーチ・監視デスクです。</translation>
    </message>
    <message>
        <source>Connect to a simulated controller inside the program.</source>
        <translation>プログラム内の模擬コントローラに接続します。</translation>
    </message>
    <message>
        <source>light, dark, or auto for the desktop&apos;s choice.</source>
        <translation>light、dark、またはデスクトップの設定に従うauto。</translation>
    </message>
    <message>
        <source>Language of the window, as a code such as de; the desktop&apos;s unless told otherwise.</source>
        <translation>ウィンドウの言語 (deなどのコード)。指定しなければデスクトップの言語。</translation>
    </message>
    <message>
        <source>Allow watching, HOLD and servo off alone, whatever the person at the desk tries.</source>
        <translation>操作者が何をしようとしても、監視、HOLD、サーボオフだけを許可します。</translation>
    </message>
    <message>
        <source>Write pictures of every page to this folder, print the status read, and end.</source>
        <translation>全ページの画像をこのフォルダに書き出し、読み出した状態を表示して終了します。</translation>
    </message>
    <message>
        <source>Print when the window was painted and when the first status was live.</source>
        <translation>ウィンドウの描画時刻と、最初の状態がライブになった時刻を表示します。</translation>
    </message>
    <message>
        <source>--demo brings its own controller: leave out --host and --profile.</source>
        <translation>--demoは専用のコントローラを使います。--hostと--profileは指定しないでください。</translation>
    </message>
    <message>
        <source>--theme must be light, dark or auto.</source>
        <translation>--themeはlight、dark、autoのいずれかにしてください。</translation>
    </message>
    <message>
        <source>--language must be one of: %1.</source>
        <translation>--languageは次のいずれかにしてください: %1。</translation>
    </message>
    <message>
        <source>“%1” is not an option.</source>
        <translation>「%1」というオプションはありません。</translation>
    </message>
    <message>
        <source>--pictures needs a folder, and --demo, --host or --profile.</source>
        <translation>--picturesにはフォルダと、--demo、--host、--profileのいずれかが必要です。</translation>
    </message>
    <message>
        <source>Write one picture of all pages, light and dark, in English, German and Japanese, and end.</source>
        <translation>全ページのライトとダーク、英語、ドイツ語、日本語での表示を1枚の画像に書き出して終了します。</translation>
    </message>
    <message>
        <source>--contact-sheet needs a file, and --demo, --host or --profile.</source>
        <translation>--contact-sheetにはファイルと、--demo、--host、--profileのいずれかが必要です。</translation>
    </message>
</context>
<context>
    <name>pendesk::Pictures</name>
    <message>
        <source>not everything was read</source>
        <translation>すべては読み出せませんでした</translation>
    </message>
    <message>
        <source>pendesk: %1 cannot be written.</source>
        <translation>pendesk: %1に書き込めません。</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>機種</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>ソフトウェア</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>サイクル</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運転</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>ホールド</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Executing</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>Pictures are in %1</source>
        <translation>画像の保存先: %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>フォルダ%1を作成できません</translation>
    </message>
    <message>
        <source>no live controller within 5 s: %1</source>
        <translation>5秒以内にライブのコントローラが見つかりません: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1に書き込めません</translation>
    </message>
    <message>
        <source>pendesk: %1.</source>
        <translation>pendesk: %1。</translation>
    </message>
</context>
<context>
    <name>pendeskctl</name>
    <message>
        <source>It stopped at %1. As it was it is in %2; “restore” that one with this name puts it back.</source>
        <translation>%1で停止しました。元の内容は%2にあります。この名前を指定してそれを「restore」すると元に戻ります。</translation>
    </message>
    <message>
        <source>Delete all but the newest N backups afterwards, never the last good one.</source>
        <translation>終了後、最新のN個以外のバックアップを削除します。最後の良好なバックアップは削除しません。</translation>
    </message>
    <message>
        <source>Delete backups older than N days afterwards, never the last good one.</source>
        <translation>終了後、N日より古いバックアップを削除します。最後の良好なバックアップは削除しません。</translation>
    </message>
    <message>
        <source>Reads all files of the controller into DIR/&lt;controller&gt;/&lt;UTC time&gt;, in BagIt form.</source>
        <translation>コントローラの全ファイルを、BagIt形式でDIR/&lt;controller&gt;/&lt;UTC time&gt;に読み出します。</translation>
    </message>
    <message>
        <source>Reads a backup and tells whether it is what was written.</source>
        <translation>バックアップを読み、書き込んだときのままかどうかを知らせます。</translation>
    </message>
    <message>
        <source>Only print what would be done.</source>
        <translation>実行される内容を表示するだけにします。</translation>
    </message>
    <message>
        <source>The backup is not as it was written; “verify” tells what is wrong. Nothing was done with it.</source>
        <translation>バックアップが書き込んだときと異なります。誤りの内容は「verify」で分かります。このバックアップでは何も実行していません。</translation>
    </message>
    <message>
        <source>“%1” is no file name.</source>
        <translation>「%1」はファイル名に使えません。</translation>
    </message>
    <message>
        <source>Print for people instead of JSON.</source>
        <translation>JSONではなく、人が読む形で表示します。</translation>
    </message>
    <message>
        <source>The request that a reply answers.</source>
        <translation>応答が答える要求。</translation>
    </message>
    <message>
        <source>The port of the packets: 10040 or 10041.</source>
        <translation>パケットのポート: 10040または10041。</translation>
    </message>
    <message>
        <source>A packet; without any, one a line on stdin.</source>
        <translation>パケット。指定しなければ、stdinから1行に1つ。</translation>
    </message>
    <message>
        <source>A job is running; files are not changed meanwhile.</source>
        <translation>ジョブが運転中です。その間はファイルを変更しません。</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address.</source>
        <translation>名前「%1」のIPv4アドレスがありません。</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>フォルダ「%1」を作成できません。</translation>
    </message>
    <message>
        <source>%1 exists and is left alone; --yes replaces it.</source>
        <translation>%1はすでにあるため、そのままにします。置き換えるには--yesを指定してください。</translation>
    </message>
    <message>
        <source>“%1” is no name that a controller takes.</source>
        <translation>「%1」はコントローラが受け付ける名前ではありません。</translation>
    </message>
    <message>
        <source>%1 exists at the controller and is left alone; --replace replaces it.</source>
        <translation>%1はコントローラにすでにあるため、そのままにします。置き換えるには--replaceを指定してください。</translation>
    </message>
    <message>
        <source>Lists the jobs.</source>
        <translation>ジョブの一覧を表示します。</translation>
    </message>
    <message>
        <source>The folder for what comes; for rm, for the copies.</source>
        <translation>取得したファイルの保存先フォルダ。rmでは写しの保存先。</translation>
    </message>
    <message>
        <source>put: replace what the controller has.</source>
        <translation>put: コントローラにあるものを置き換えます。</translation>
    </message>
    <message>
        <source>Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”.</source>
        <translation>「ls」、「get NAME…」、「put FILE…」、「rm NAME…」のいずれかを指定してください。</translation>
    </message>
    <message>
        <source>read status, job, position and system information</source>
        <translation>状態、ジョブ、位置、システム情報を読み出します</translation>
    </message>
    <message>
        <source>read model, system software and parameter version</source>
        <translation>機種、システムソフトウェア、パラメータバージョンを読み出します</translation>
    </message>
    <message>
        <source>read the active alarms, or a list of the history</source>
        <translation>発生中のアラーム、または履歴のリストを読み出します</translation>
    </message>
    <message>
        <source>read where the robot stands</source>
        <translation>ロボットの現在位置を読み出します</translation>
    </message>
    <message>
        <source>list the jobs</source>
        <translation>ジョブの一覧を表示します</translation>
    </message>
    <message>
        <source>read I/O, write a network input</source>
        <translation>I/Oを読み出し、ネットワーク入力を書き込みます</translation>
    </message>
    <message>
        <source>read and write registers</source>
        <translation>レジスタを読み書きします</translation>
    </message>
    <message>
        <source>read and write variables</source>
        <translation>変数を読み書きします</translation>
    </message>
    <message>
        <source>list, read, send and delete files</source>
        <translation>ファイルの一覧表示、読出し、送信、削除を行います</translation>
    </message>
    <message>
        <source>read all files of a controller into a new backup</source>
        <translation>コントローラの全ファイルを新しいバックアップに読み出します</translation>
    </message>
    <message>
        <source>tell whether a backup is what was written</source>
        <translation>バックアップが書き込んだときのままかどうかを知らせます</translation>
    </message>
    <message>
        <source>compare two backups, or one with the controller</source>
        <translation>2つのバックアップ、またはバックアップとコントローラを比較します</translation>
    </message>
    <message>
        <source>send back what differs from a backup</source>
        <translation>バックアップと異なるものを送り戻します</translation>
    </message>
    <message>
        <source>read values again and again</source>
        <translation>値を繰り返し読み出します</translation>
    </message>
    <message>
        <source>take packets given in hex apart</source>
        <translation>16進で与えたパケットを分解して表示します</translation>
    </message>
    <message>
        <source>Usage: pendeskctl VERB [options]</source>
        <translation>使い方: pendeskctl VERB [options]</translation>
    </message>
    <message>
        <source>pendeskctl VERB --help tells more.</source>
        <translation>詳しくは pendeskctl VERB --help を参照してください。</translation>
    </message>
    <message>
        <source>there is no verb “%1”.</source>
        <translation>「%1」というVERBはありません。</translation>
    </message>
    <message>
        <source>%1: the controller has no such row of I/O groups.</source>
        <translation>%1: コントローラにその範囲のI/Oグループはありません。</translation>
    </message>
    <message>
        <source>Instance of the first variable on this controller, 0 or 1 (parameter RS022).</source>
        <translation>このコントローラの先頭の変数のインスタンス、0または1 (パラメータRS022)。</translation>
    </message>
    <message>
        <source>Print JSON.</source>
        <translation>JSONを表示します。</translation>
    </message>
    <message>
        <source>Yes, write: what changes something does nothing without it.</source>
        <translation>書込みを承認します。指定しなければ、変更を伴う操作は何も行いません。</translation>
    </message>
    <message>
        <source>No progress and no remarks.</source>
        <translation>進行状況と注記を表示しません。</translation>
    </message>
    <message>
        <source>--numbering takes 0 or 1.</source>
        <translation>--numberingには0または1を指定してください。</translation>
    </message>
    <message>
        <source>Name the controller with --host or --profile.</source>
        <translation>--hostまたは--profileでコントローラを指定してください。</translation>
    </message>
    <message>
        <source>See pendeskctl %1 --help.</source>
        <translation>pendeskctl %1 --help を参照してください。</translation>
    </message>
    <message>
        <source>This changes something at the controller or on this computer. Add --yes to do it.</source>
        <translation>コントローラまたはこのコンピュータの内容が変わります。実行するには--yesを付けてください。</translation>
    </message>
    <message>
        <source>Say what to read.</source>
        <translation>読み出すものを指定してください。</translation>
    </message>
    <message>
        <source>Positions are not written from the command line.</source>
        <translation>位置はコマンドラインからは書き込めません。</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1は書き込めません。</translation>
    </message>
    <message>
        <source>Nobody has verified which instance a variable has on this controller. Compare one value with the pendant, then say --numbering 0 or --numbering 1.</source>
        <translation>このコントローラの変数がどのインスタンスかは、まだ照合されていません。値を1つペンダントと比較してから、--numbering 0または--numbering 1を指定してください。</translation>
    </message>
    <message>
        <source>Another value was read back: %1</source>
        <translation>別の値が読み戻されました: %1</translation>
    </message>
    <message>
        <source>io set takes one signal, such as 27010, and 0 or 1.</source>
        <translation>io setには、27010のような信号を1つと、0または1を指定してください。</translation>
    </message>
    <message>
        <source>%1 cannot be written: HSES writes network inputs alone.</source>
        <translation>%1は書き込めません。HSESで書き込めるのはネットワーク入力だけです。</translation>
    </message>
    <message>
        <source>Say “get NAME…” or “set NAME VALUE”.</source>
        <translation>「get NAME…」または「set NAME VALUE」を指定してください。</translation>
    </message>
    <message>
        <source>Reads model, system software and parameter version.</source>
        <translation>機種、システムソフトウェア、パラメータバージョンを読み出します。</translation>
    </message>
    <message>
        <source>In pulses instead of the base frame.</source>
        <translation>ベース座標ではなくパルスで表示します。</translation>
    </message>
    <message>
        <source>A list of the history instead: major, minor, user, system or offline.</source>
        <translation>代わりに履歴のリスト: major、minor、user、system、offlineのいずれか。</translation>
    </message>
    <message>
        <source>Reads the active alarms, newest first.</source>
        <translation>発生中のアラームを新しい順に読み出します。</translation>
    </message>
    <message>
        <source>--history takes major, minor, user, system or offline.</source>
        <translation>--historyにはmajor、minor、user、system、offlineのいずれかを指定してください。</translation>
    </message>
    <message>
        <source>Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input.</source>
        <translation>I/Oグループの範囲 (2701..2710) または信号 (27010、IN#(1)) を読み出します。ネットワーク入力を1つ書き込みます。</translation>
    </message>
    <message>
        <source>Reads registers; writes one and reads it back.</source>
        <translation>レジスタを読み出します。1つを書き込み、読み戻します。</translation>
    </message>
    <message>
        <source>Reads variables B I D R S P BP EX; writes one and reads it back.</source>
        <translation>変数B I D R S P BP EXを読み出します。1つを書き込み、読み戻します。</translation>
    </message>
    <message>
        <source>Time between two readings: 1s, 200ms.</source>
        <translation>読出しの間隔: 1s、200ms。</translation>
    </message>
    <message>
        <source>End after so many readings.</source>
        <translation>この回数だけ読み出したら終了します。</translation>
    </message>
    <message>
        <source>Reads variables, registers (M005) and I/O again and again, one line of JSON with --json.</source>
        <translation>変数、レジスタ (M005)、I/Oを繰り返し読み出します。--jsonを指定すると1回につきJSON 1行です。</translation>
    </message>
    <message>
        <source>Reads status, executing job, position and system information once.</source>
        <translation>状態、実行中のジョブ、位置、システム情報を1回読み出します。</translation>
    </message>
    <message>
        <source>Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a copy is written here. What exists is replaced by get with --yes, by put with --replace; put and rm need --yes.</source>
        <translation>ファイルの一覧、読み出し、送信、削除を行います。送信したファイルは読み戻され、削除の前にはここにコピーが書き込まれます。既にあるものは、get では --yes、put では --replace で置き換えられます。put と rm には --yes が必要です。</translation>
    </message>
    <message>
        <source>The controller lists no file that “%1” matches.</source>
        <translation>「%1」に一致するファイルはコントローラの一覧にありません。</translation>
    </message>
    <message>
        <source>The controller is named with --host H, or with --profile NAME as Pendesk keeps it.</source>
        <translation>コントローラは --host H、または Pendesk に保存された --profile NAME で指定します。</translation>
    </message>
    <message>
        <source>What changes something does nothing without --yes.</source>
        <translation>何かを変更する操作は、--yes がなければ何も行いません。</translation>
    </message>
    <message>
        <source>Exit codes: 0 done, 1 differences, 2 wrong call, 3 no answer or outcome unknown, 4 refused,
5 local file error, 6 verification failed, 7 done in part.</source>
        <translation>終了コード: 0 完了、1 相違あり、2 呼び出しの誤り、3 応答なしまたは結果不明、4 拒否、
5 ローカルファイルのエラー、6 検証不合格、7 一部完了。</translation>
    </message>
    <message>
        <source>Nobody has verified how this controller numbers its variables (parameter RS022), so these may be their neighbours. --numbering 0 or --numbering 1 settles it.</source>
        <translation>このコントローラの変数の番号付け（パラメータ RS022）は確認されていないため、隣の変数の値かもしれません。--numbering 0 または --numbering 1 で確定します。</translation>
    </message>
    <message>
        <source>Print this and end.</source>
        <translation>これを表示して終了します。</translation>
    </message>
    <message>
        <source>Files restored: %1. The fresh backup is %2.</source>
        <translation>復元したファイル: %1。新しいバックアップは %2 です。</translation>
    </message>
    <message>
        <source>The software of the controller is another than that with which the numbering was verified. Verify it again, or say --numbering 0 or --numbering 1.</source>
        <translation>コントローラのソフトウェアは、番号付けを確認したときのものと異なります。もう一度確認するか、--numbering 0 または --numbering 1 を指定してください。</translation>
    </message>
    <message>
        <source>Also read ALL.PRM, which repeats the other parameter files and takes a real controller 45 s.</source>
        <translation>ALL.PRMも読み出します。ほかのパラメータファイルと同じ内容で、実機では45秒かかります。</translation>
    </message>
    <message>
        <source>The encoding of texts, such as Shift_JIS.</source>
        <translation>テキストの文字コード (例: Shift_JIS)。</translation>
    </message>
    <message>
        <source>Looks at jobs as before they are sent, and prints what is wrong or odd; exit code 1 if a controller would refuse one.</source>
        <translation>送信前と同じようにジョブを確認し、誤りや不審な点を表示します。コントローラが拒否するジョブがあれば終了コードは1です。</translation>
    </message>
    <message>
        <source>Say the files or a folder.</source>
        <translation>ファイルまたはフォルダを指定してください。</translation>
    </message>
    <message>
        <source>“%1” is no encoding.</source>
        <translation>「%1」という文字コードはありません。</translation>
    </message>
    <message>
        <source>Not counted: %1 counters, %2 logs, %3 other files with nothing but dates, hours or check lines.</source>
        <translation>対象外: カウンタ%1件、ログ%2件、日付、時間、チェック行以外に違いのないその他のファイル%3件。</translation>
    </message>
    <message>
        <source>Count dates, counters, logs, blanks and line ends as differences too.</source>
        <translation>日付、カウンタ、ログ、空白、行末の違いも差異として数えます。</translation>
    </message>
    <message>
        <source>Compares two backups or folders of controller files, or one with the controller, in words; exit code 1 if configuration or data differ.</source>
        <translation>2つのバックアップまたはコントローラファイルのフォルダ、もしくはその1つとコントローラを比較し、違いを文章で表示します。設定またはデータが異なれば終了コードは1です。</translation>
    </message>
    <message>
        <source>The encoding of texts: %1.</source>
        <translation>テキストの文字コード: %1。</translation>
    </message>
    <message>
        <source>The controller model: %1.</source>
        <translation>コントローラの機種: %1。</translation>
    </message>
    <message>
        <source>look at jobs before they are sent</source>
        <translation>送信する前にジョブを確認します</translation>
    </message>
    <message>
        <source>tell what controller files say</source>
        <translation>コントローラファイルの内容を表示します</translation>
    </message>
    <message>
        <source>The encoding of the pendant&apos;s language instead of the stored one: %1.</source>
        <translation>保存された文字コードの代わりに使う、ペンダントの言語の文字コード: %1。</translation>
    </message>
    <message>
        <source>--encoding takes one of %1.</source>
        <translation>--encodingには%1のいずれかを指定してください。</translation>
    </message>
    <message>
        <source>--%1 takes a whole number that is not negative.</source>
        <translation>--%1には負ではない整数を指定してください。</translation>
    </message>
    <message>
        <source>%1 does not take “%2”. See pendeskctl %1 --help.</source>
        <translation>%1に「%2」は指定できません。pendeskctl %1 --help を参照してください。</translation>
    </message>
    <message>
        <source>%1 takes %2. See pendeskctl %1 --help.</source>
        <translation>%1には%2を指定してください。pendeskctl %1 --help を参照してください。</translation>
    </message>
    <message>
        <source>Reads where a control group stands: the first robot, or R2, B1, S1.</source>
        <translation>制御グループ (最初のロボット、またはR2、B1、S1) の現在位置を読み出します。</translation>
    </message>
    <message>
        <source>“%1” is no control group of a %2: say R1, B1 or S1.</source>
        <translation>「%1」は%2の制御グループではありません。R1、B1、S1のいずれかを指定してください。</translation>
    </message>
    <message>
        <source>The backup (left) is of another robot than the controller (right). Nothing was sent. Single jobs and names can be sent by their names.</source>
        <translation>バックアップ (左) はコントローラ (右) とは別のロボットのものです。何も送信していません。個々のジョブと名称は、名前を指定すれば送信できます。</translation>
    </message>
    <message>
        <source>Sends back what differs from a backup of the same robot: first a fresh backup beside it, then file by file, each read back. Tools, frames and areas only by name; parameters, calibration and ladder never; never while a job runs.</source>
        <translation>同じロボットのバックアップと異なるものを送り戻します。最初にその隣に新しいバックアップを作成し、次に1ファイルずつ送信して読み戻します。ツール、座標、領域は名前を指定したときだけ送信します。パラメータ、キャリブレーション、ラダーは送信しません。ジョブの運転中は行いません。</translation>
    </message>
    <message>
        <source>%1 bytes that are not a text.</source>
        <translation>テキストではない%1バイト。</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>%1行目: %2</translation>
    </message>
    <message>
        <source>The encoding of the pendant.</source>
        <translation>ペンダントの文字コード。</translation>
    </message>
    <message>
        <source>Tells what controller files say: names, tools, frames, variables, parameters, ladder, logs. Addresses, users and passwords are masked.</source>
        <translation>コントローラファイルの内容 (名称、ツール、座標、変数、パラメータ、ラダー、ログ) を表示します。アドレス、ユーザ、パスワードは伏せます。</translation>
    </message>
    <message>
        <source>Say a backup, a folder or files.</source>
        <translation>バックアップ、フォルダ、ファイルのいずれかを指定してください。</translation>
    </message>
    <message>
        <source>There is no encoding “%1”.</source>
        <translation>文字コード「%1」はありません。</translation>
    </message>
    <message>
        <source>--every takes a time such as 200ms or 1s.</source>
        <translation>--everyには200msや1sのような時間を指定してください。</translation>
    </message>
    <message>
        <source>Another signal of the group changed meanwhile; nothing was sent.</source>
        <translation>その間にグループ内のほかの信号が変わりました。何も送信していません。</translation>
    </message>
    <message>
        <source>not used in these files</source>
        <translation>これらのファイルでは未使用</translation>
    </message>
    <message>
        <source>a job that is known when the line runs</source>
        <translation>行の実行時に決まるジョブ</translation>
    </message>
    <message>
        <source>no file has it</source>
        <translation>どのファイルにもありません</translation>
    </message>
    <message>
        <source>Tells where variables, signals, registers, tools, frames, macros, alarms and jobs are used: in jobs, in the ladder, in files of names.</source>
        <translation>変数、信号、レジスタ、ツール、座標、マクロ、アラーム、ジョブの使用箇所（ジョブ、ラダー、名称ファイル）を表示します。</translation>
    </message>
    <message>
        <source>Say what to look for, such as B012, IN#(5) or a job.</source>
        <translation>B012、IN#(5)、ジョブ名など、検索対象を指定してください。</translation>
    </message>
    <message>
        <source>Tells which job calls, jumps to or starts which, line by line.</source>
        <translation>どのジョブがどのジョブを呼出し、ジャンプ、起動するかを行ごとに表示します。</translation>
    </message>
    <message>
        <source>Tells what is worth a look: jobs that nothing names, jobs that are missing, outputs with several writers, variables that are never written, tools that were not entered.</source>
        <translation>確認すべき点を表示します: 参照されないジョブ、存在しないジョブ、複数箇所で書き込まれる出力、書き込まれない変数、未入力のツール。</translation>
    </message>
    <message>
        <source>tell where variables, signals and jobs are used</source>
        <translation>変数・信号・ジョブの使用箇所を表示</translation>
    </message>
    <message>
        <source>tell which job calls which</source>
        <translation>ジョブの呼出し関係を表示</translation>
    </message>
    <message>
        <source>tell what in the files is worth a look</source>
        <translation>ファイル内の確認すべき点を表示</translation>
    </message>
</context>
<context>
    <name>pendeskctl::AlarmReader</name>
    <message>
        <source>There are no alarms.</source>
        <translation>アラームはありません。</translation>
    </message>
</context>
<context>
    <name>pendeskctl::Gap</name>
    <message>
        <source>Answers again after %1 s.</source>
        <translation>%1 秒後に応答が再開しました。</translation>
    </message>
</context>
<context>
    <name>protocol</name>
    <message>
        <source>refused with status %1, which is not in the code list</source>
        <translation>ステータス%1で拒否されました (コード一覧にありません)</translation>
    </message>
    <message>
        <source>%1 refused, with a code that is not in the code list</source>
        <translation>%1は拒否されました (コードは一覧にありません)</translation>
    </message>
    <message>
        <source>the controller did not answer; nothing was changed</source>
        <translation>コントローラが応答しませんでした。何も変更していません</translation>
    </message>
    <message>
        <source>no answer: it may or may not have happened — look at the robot</source>
        <translation>応答がありません。実行されたかどうかは不明です — ロボットを確認してください</translation>
    </message>
    <message>
        <source>the answer does not fit the question</source>
        <translation>応答が要求と合いません</translation>
    </message>
    <message>
        <source>nothing was sent</source>
        <translation>何も送信していません</translation>
    </message>
    <message>
        <source>this computer&apos;s network refused</source>
        <translation>このコンピュータのネットワークが拒否しました</translation>
    </message>
    <message>
        <source>this cannot be sent to a controller</source>
        <translation>これはコントローラに送信できません</translation>
    </message>
    <message>
        <source>a file on this computer could not be read or written</source>
        <translation>このコンピュータのファイルを読み書きできませんでした</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>the command is faulty</source>
        <translation>コマンドに誤りがあります</translation>
    </message>
    <message>
        <source>the command has the wrong number of operands</source>
        <translation>コマンドのオペランドの数が違います</translation>
    </message>
    <message>
        <source>an operand is out of its range</source>
        <translation>オペランドが範囲外です</translation>
    </message>
    <message>
        <source>an operand has the wrong length</source>
        <translation>オペランドの長さが違います</translation>
    </message>
    <message>
        <source>the device holds too many files</source>
        <translation>デバイスのファイルが多すぎます</translation>
    </message>
    <message>
        <source>delete files that are not needed</source>
        <translation>不要なファイルを削除してください</translation>
    </message>
    <message>
        <source>the robot is running</source>
        <translation>ロボットが動作中です</translation>
    </message>
    <message>
        <source>wait until it has stopped, or hold it</source>
        <translation>停止するまで待つか、ホールドしてください</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>ペンダントによるホールド中です</translation>
    </message>
    <message>
        <source>release HOLD on the pendant</source>
        <translation>ペンダントでHOLDを解除してください</translation>
    </message>
    <message>
        <source>held by the playback panel</source>
        <translation>プレイバックパネルによるホールド中です</translation>
    </message>
    <message>
        <source>release HOLD on the panel or pendant</source>
        <translation>パネルまたはペンダントでHOLDを解除してください</translation>
    </message>
    <message>
        <source>held by an external signal</source>
        <translation>外部信号によるホールド中です</translation>
    </message>
    <message>
        <source>release the external hold signal</source>
        <translation>外部ホールド信号を解除してください</translation>
    </message>
    <message>
        <source>held by a command</source>
        <translation>コマンドによるホールド中です</translation>
    </message>
    <message>
        <source>switch HOLD off</source>
        <translation>HOLDをオフにしてください</translation>
    </message>
    <message>
        <source>an alarm or error is present</source>
        <translation>アラームまたはエラーが発生しています</translation>
    </message>
    <message>
        <source>remove its cause, then reset the alarm</source>
        <translation>原因を取り除いてから、アラームをリセットしてください</translation>
    </message>
    <message>
        <source>servo power is off</source>
        <translation>サーボ電源がオフです</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>サーボをオンにしてください</translation>
    </message>
    <message>
        <source>the controller is in the wrong mode</source>
        <translation>コントローラのモードが違います</translation>
    </message>
    <message>
        <source>turn the pendant key to the mode needed, usually PLAY in REMOTE</source>
        <translation>ペンダントのモードキーを必要なモードにしてください (通常はREMOTEでPLAY)</translation>
    </message>
    <message>
        <source>the files are in use by another function</source>
        <translation>ファイルは別の機能が使用中です</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>しばらくしてからやり直してください</translation>
    </message>
    <message>
        <source>command remote is not enabled</source>
        <translation>コマンドリモートが有効になっていません</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and enable command remote</source>
        <translation>ペンダントのモードキーをREMOTEにし、コマンドリモートを有効にしてください</translation>
    </message>
    <message>
        <source>this data may not be accessed</source>
        <translation>このデータにはアクセスできません</translation>
    </message>
    <message>
        <source>check the security mode and the data protection on the pendant</source>
        <translation>ペンダントでセキュリティモードとデータ保護を確認してください</translation>
    </message>
    <message>
        <source>this data may not be loaded</source>
        <translation>このデータはロードできません</translation>
    </message>
    <message>
        <source>the data is being edited</source>
        <translation>データは編集中です</translation>
    </message>
    <message>
        <source>leave the editor on the pendant</source>
        <translation>ペンダントで編集を終了してください</translation>
    </message>
    <message>
        <source>a coordinate conversion is in progress</source>
        <translation>座標変換の実行中です</translation>
    </message>
    <message>
        <source>try again when it has ended</source>
        <translation>終わってからやり直してください</translation>
    </message>
    <message>
        <source>servo power must be on first</source>
        <translation>先にサーボ電源をオンにする必要があります</translation>
    </message>
    <message>
        <source>the home position must be set or checked</source>
        <translation>原点位置の設定または確認が必要です</translation>
    </message>
    <message>
        <source>check the home position on the pendant</source>
        <translation>ペンダントで原点位置を確認してください</translation>
    </message>
    <message>
        <source>the position must be checked</source>
        <translation>位置確認が必要です</translation>
    </message>
    <message>
        <source>confirm the position on the pendant</source>
        <translation>ペンダントで位置確認を行ってください</translation>
    </message>
    <message>
        <source>the present position is not available</source>
        <translation>現在位置を取得できません</translation>
    </message>
    <message>
        <source>the panel lock prohibits a change of mode or cycle</source>
        <translation>パネルロックにより、モードとサイクルの変更が禁止されています</translation>
    </message>
    <message>
        <source>release the panel lock</source>
        <translation>パネルロックを解除してください</translation>
    </message>
    <message>
        <source>the panel lock prohibits a start</source>
        <translation>パネルロックにより、起動が禁止されています</translation>
    </message>
    <message>
        <source>the user frame is not taught</source>
        <translation>ユーザ座標が教示されていません</translation>
    </message>
    <message>
        <source>teach the user frame</source>
        <translation>ユーザ座標を教示してください</translation>
    </message>
    <message>
        <source>the user frame data is damaged</source>
        <translation>ユーザ座標のデータが壊れています</translation>
    </message>
    <message>
        <source>teach the user frame again</source>
        <translation>ユーザ座標を教示し直してください</translation>
    </message>
    <message>
        <source>the control group is wrong</source>
        <translation>制御グループが違います</translation>
    </message>
    <message>
        <source>choose a control group that this controller has</source>
        <translation>このコントローラにある制御グループを選んでください</translation>
    </message>
    <message>
        <source>the base axis data is wrong</source>
        <translation>ベース軸のデータに誤りがあります</translation>
    </message>
    <message>
        <source>a relative job may not be converted</source>
        <translation>相対ジョブの変換は許可されていません</translation>
    </message>
    <message>
        <source>permit the conversion on the pendant</source>
        <translation>ペンダントで変換を許可してください</translation>
    </message>
    <message>
        <source>a parameter prohibits calling the master job</source>
        <translation>パラメータにより、マスタジョブの呼出しが禁止されています</translation>
    </message>
    <message>
        <source>permit the master call on the pendant</source>
        <translation>ペンダントでマスタ呼出しを許可してください</translation>
    </message>
    <message>
        <source>the master job may not be called while operating</source>
        <translation>動作中はマスタジョブを呼び出せません</translation>
    </message>
    <message>
        <source>wait until the operation has ended</source>
        <translation>動作が終わるまで待ってください</translation>
    </message>
    <message>
        <source>the teach lock prohibits calling the master job</source>
        <translation>ティーチロックにより、マスタジョブの呼出しが禁止されています</translation>
    </message>
    <message>
        <source>release the teach lock</source>
        <translation>ティーチロックを解除してください</translation>
    </message>
    <message>
        <source>robot calibration data is missing</source>
        <translation>ロボット間キャリブレーションのデータがありません</translation>
    </message>
    <message>
        <source>calibrate the robots</source>
        <translation>ロボットのキャリブレーションを行ってください</translation>
    </message>
    <message>
        <source>servo power cannot be switched on</source>
        <translation>サーボ電源をオンにできません</translation>
    </message>
    <message>
        <source>check the safety chain: emergency stop, safeguards, alarms</source>
        <translation>安全回路を確認してください: 非常停止、安全防護、アラーム</translation>
    </message>
    <message>
        <source>the coordinate system cannot be set</source>
        <translation>座標系を設定できません</translation>
    </message>
    <message>
        <source>no memory is left for jobs</source>
        <translation>ジョブ用のメモリが残っていません</translation>
    </message>
    <message>
        <source>delete jobs that are not needed</source>
        <translation>不要なジョブを削除してください</translation>
    </message>
    <message>
        <source>no memory is left for position data</source>
        <translation>位置データ用のメモリが残っていません</translation>
    </message>
    <message>
        <source>editing of this job is prohibited</source>
        <translation>このジョブの編集は禁止されています</translation>
    </message>
    <message>
        <source>remove the edit lock of the job</source>
        <translation>ジョブの編集禁止を解除してください</translation>
    </message>
    <message>
        <source>a job of that name exists</source>
        <translation>同じ名前のジョブがあります</translation>
    </message>
    <message>
        <source>delete or rename it, or permit overwriting</source>
        <translation>削除するか名前を変更するか、上書きを許可してください</translation>
    </message>
    <message>
        <source>the job was not found</source>
        <translation>ジョブが見つかりませんでした</translation>
    </message>
    <message>
        <source>check the job name</source>
        <translation>ジョブ名を確認してください</translation>
    </message>
    <message>
        <source>no job is set for execution</source>
        <translation>実行するジョブが設定されていません</translation>
    </message>
    <message>
        <source>select a job first</source>
        <translation>先にジョブを選択してください</translation>
    </message>
    <message>
        <source>position data is damaged</source>
        <translation>位置データが壊れています</translation>
    </message>
    <message>
        <source>load the job again from a backup</source>
        <translation>バックアップからジョブをロードし直してください</translation>
    </message>
    <message>
        <source>position data is missing</source>
        <translation>位置データがありません</translation>
    </message>
    <message>
        <source>teach the missing position</source>
        <translation>不足している位置を教示してください</translation>
    </message>
    <message>
        <source>the position variable has the wrong type</source>
        <translation>位置変数のタイプが違います</translation>
    </message>
    <message>
        <source>write the type that the variable is declared with</source>
        <translation>変数の宣言と同じタイプで書き込んでください</translation>
    </message>
    <message>
        <source>END was reached in a job that is not the master</source>
        <translation>マスタではないジョブでENDに達しました</translation>
    </message>
    <message>
        <source>instruction data is damaged</source>
        <translation>命令データが壊れています</translation>
    </message>
    <message>
        <source>the job name has a character that is not allowed</source>
        <translation>ジョブ名に使えない文字があります</translation>
    </message>
    <message>
        <source>rename the job</source>
        <translation>ジョブの名前を変更してください</translation>
    </message>
    <message>
        <source>a label has a character that is not allowed</source>
        <translation>ラベルに使えない文字があります</translation>
    </message>
    <message>
        <source>rename the label</source>
        <translation>ラベルの名前を変更してください</translation>
    </message>
    <message>
        <source>this system does not have the instruction</source>
        <translation>このシステムにその命令はありません</translation>
    </message>
    <message>
        <source>the job to convert has no steps</source>
        <translation>変換するジョブにステップがありません</translation>
    </message>
    <message>
        <source>the job is converted already</source>
        <translation>ジョブはすでに変換されています</translation>
    </message>
    <message>
        <source>the user frame must be taught</source>
        <translation>ユーザ座標の教示が必要です</translation>
    </message>
    <message>
        <source>relative jobs or independent control are not permitted</source>
        <translation>相対ジョブまたは独立制御は許可されていません</translation>
    </message>
    <message>
        <source>an instruction has a syntax error</source>
        <translation>命令に構文エラーがあります</translation>
    </message>
    <message>
        <source>correct the instruction</source>
        <translation>命令を修正してください</translation>
    </message>
    <message>
        <source>the position data has an error</source>
        <translation>位置データに誤りがあります</translation>
    </message>
    <message>
        <source>correct the position section</source>
        <translation>位置データの部分を修正してください</translation>
    </message>
    <message>
        <source>NOP or END is missing</source>
        <translation>NOPまたはENDがありません</translation>
    </message>
    <message>
        <source>begin the instructions with NOP and end them with END</source>
        <translation>命令をNOPで始め、ENDで終えてください</translation>
    </message>
    <message>
        <source>the format is wrong</source>
        <translation>形式に誤りがあります</translation>
    </message>
    <message>
        <source>the number of data is wrong</source>
        <translation>データの数が違います</translation>
    </message>
    <message>
        <source>correct the counts in the NPOS line</source>
        <translation>NPOSの行の数を修正してください</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>値が範囲外です</translation>
    </message>
    <message>
        <source>correct the value</source>
        <translation>値を修正してください</translation>
    </message>
    <message>
        <source>there is a syntax error outside the instructions</source>
        <translation>命令以外の部分に構文エラーがあります</translation>
    </message>
    <message>
        <source>correct the header of the file</source>
        <translation>ファイルのヘッダを修正してください</translation>
    </message>
    <message>
        <source>a pseudo instruction is wrong</source>
        <translation>疑似命令に誤りがあります</translation>
    </message>
    <message>
        <source>correct the line that starts with slashes</source>
        <translation>スラッシュで始まる行を修正してください</translation>
    </message>
    <message>
        <source>a record of a condition file has an error</source>
        <translation>条件ファイルのレコードに誤りがあります</translation>
    </message>
    <message>
        <source>a record of a job has an error</source>
        <translation>ジョブのレコードに誤りがあります</translation>
    </message>
    <message>
        <source>the data comes from a different system</source>
        <translation>別のシステムのデータです</translation>
    </message>
    <message>
        <source>the welding type does not match</source>
        <translation>溶接のタイプが一致しません</translation>
    </message>
    <message>
        <source>the robot or station is operating</source>
        <translation>ロボットまたはステーションが動作中です</translation>
    </message>
    <message>
        <source>back up when nothing moves</source>
        <translation>何も動いていないときにバックアップしてください</translation>
    </message>
    <message>
        <source>the device has too little memory</source>
        <translation>デバイスの容量が不足しています</translation>
    </message>
    <message>
        <source>free memory on the device or use a larger one</source>
        <translation>デバイスの空きを増やすか、容量の大きいものを使ってください</translation>
    </message>
    <message>
        <source>the device cannot be accessed</source>
        <translation>デバイスにアクセスできません</translation>
    </message>
    <message>
        <source>check that the device is inserted</source>
        <translation>デバイスが挿入されているか確認してください</translation>
    </message>
    <message>
        <source>a backup was not expected now</source>
        <translation>今はバックアップを受け付けない状態です</translation>
    </message>
    <message>
        <source>the image is larger than the RAM area</source>
        <translation>イメージがRAM領域より大きいです</translation>
    </message>
    <message>
        <source>enlarge the RAM area for backups</source>
        <translation>バックアップ用のRAM領域を増やしてください</translation>
    </message>
    <message>
        <source>no memory was reserved at power-on</source>
        <translation>電源投入時にメモリが確保されていません</translation>
    </message>
    <message>
        <source>switch the controller off and on</source>
        <translation>コントローラの電源を入れ直してください</translation>
    </message>
    <message>
        <source>the backup file information cannot be accessed</source>
        <translation>バックアップファイルの情報にアクセスできません</translation>
    </message>
    <message>
        <source>the old backup could not be removed</source>
        <translation>古いバックアップを削除できませんでした</translation>
    </message>
    <message>
        <source>the backup could not be renamed</source>
        <translation>バックアップの名前を変更できませんでした</translation>
    </message>
    <message>
        <source>the drive name is too long</source>
        <translation>ドライブ名が長すぎます</translation>
    </message>
    <message>
        <source>the device is the wrong one</source>
        <translation>デバイスが違います</translation>
    </message>
    <message>
        <source>set the automatic backup to the RAM disk</source>
        <translation>自動バックアップの保存先をRAMディスクにしてください</translation>
    </message>
    <message>
        <source>a system error occurred</source>
        <translation>システムエラーが発生しました</translation>
    </message>
    <message>
        <source>automatic backup is not available</source>
        <translation>自動バックアップは使用できません</translation>
    </message>
    <message>
        <source>set up automatic backup on the pendant</source>
        <translation>ペンダントで自動バックアップを設定してください</translation>
    </message>
    <message>
        <source>an automatic backup is running</source>
        <translation>自動バックアップの実行中です</translation>
    </message>
    <message>
        <source>the controller does not know this command</source>
        <translation>コントローラがこのコマンドに対応していません</translation>
    </message>
    <message>
        <source>the number does not exist on this controller</source>
        <translation>その番号はこのコントローラにありません</translation>
    </message>
    <message>
        <source>check the number and the variable numbering</source>
        <translation>番号と変数番号の方式を確認してください</translation>
    </message>
    <message>
        <source>the element does not exist on this controller</source>
        <translation>その要素はこのコントローラにありません</translation>
    </message>
    <message>
        <source>the reply would be too large for the hardware</source>
        <translation>応答がハードウェアの上限を超えます</translation>
    </message>
    <message>
        <source>ask for less at once</source>
        <translation>一度に要求する量を減らしてください</translation>
    </message>
    <message>
        <source>the reply would be too large</source>
        <translation>応答が大きすぎます</translation>
    </message>
    <message>
        <source>the position variable is not defined</source>
        <translation>位置変数が定義されていません</translation>
    </message>
    <message>
        <source>teach or write it first</source>
        <translation>先に教示するか、書き込んでください</translation>
    </message>
    <message>
        <source>this data may not be used</source>
        <translation>このデータは使用できません</translation>
    </message>
    <message>
        <source>the size of the request data is wrong</source>
        <translation>要求データのサイズが違います</translation>
    </message>
    <message>
        <source>the data is not set</source>
        <translation>データが設定されていません</translation>
    </message>
    <message>
        <source>set it first</source>
        <translation>先に設定してください</translation>
    </message>
    <message>
        <source>the application is not registered</source>
        <translation>アプリケーションが登録されていません</translation>
    </message>
    <message>
        <source>the type is not registered</source>
        <translation>タイプが登録されていません</translation>
    </message>
    <message>
        <source>the control group setting is wrong</source>
        <translation>制御グループの設定に誤りがあります</translation>
    </message>
    <message>
        <source>name either robots or stations that this controller has</source>
        <translation>このコントローラにあるロボットかステーションのどちらかを指定してください</translation>
    </message>
    <message>
        <source>the speed setting is wrong</source>
        <translation>速度の設定に誤りがあります</translation>
    </message>
    <message>
        <source>use percent for joint and mm/s or °/s for straight moves</source>
        <translation>関節動作には%、直線動作にはmm/sか°/sを使ってください</translation>
    </message>
    <message>
        <source>no speed is given</source>
        <translation>速度が指定されていません</translation>
    </message>
    <message>
        <source>give a speed above 0</source>
        <translation>0より大きい速度を指定してください</translation>
    </message>
    <message>
        <source>the coordinate system setting is wrong</source>
        <translation>座標系の設定に誤りがあります</translation>
    </message>
    <message>
        <source>the type or form setting is wrong</source>
        <translation>タイプまたは形態の設定に誤りがあります</translation>
    </message>
    <message>
        <source>the tool number is wrong</source>
        <translation>ツール番号に誤りがあります</translation>
    </message>
    <message>
        <source>use 0 to 63</source>
        <translation>0から63までを使ってください</translation>
    </message>
    <message>
        <source>the user frame number is wrong</source>
        <translation>ユーザ座標番号に誤りがあります</translation>
    </message>
    <message>
        <source>use 1 to 63 with a user frame, else 0</source>
        <translation>ユーザ座標では1から63まで、それ以外は0を使ってください</translation>
    </message>
    <message>
        <source>internal error of the controller: data area</source>
        <translation>コントローラの内部エラー: データ領域</translation>
    </message>
    <message>
        <source>internal error of the controller: reply area exceeded</source>
        <translation>コントローラの内部エラー: 応答領域の超過</translation>
    </message>
    <message>
        <source>internal error of the controller: element size mismatch</source>
        <translation>コントローラの内部エラー: 要素サイズの不一致</translation>
    </message>
    <message>
        <source>internal error of the controller: customised function</source>
        <translation>コントローラの内部エラー: カスタマイズ機能</translation>
    </message>
    <message>
        <source>another error</source>
        <translation>その他のエラー</translation>
    </message>
    <message>
        <source>busy with another command</source>
        <translation>別のコマンドの処理中です</translation>
    </message>
    <message>
        <source>another access is in progress</source>
        <translation>別のアクセスが進行中です</translation>
    </message>
    <message>
        <source>the backup parameter setting is wrong</source>
        <translation>バックアップのパラメータ設定に誤りがあります</translation>
    </message>
    <message>
        <source>the backup file was not created</source>
        <translation>バックアップファイルが作成されませんでした</translation>
    </message>
    <message>
        <source>check that the controller is in remote mode</source>
        <translation>コントローラがリモートモードか確認してください</translation>
    </message>
    <message>
        <source>internal system error of the controller</source>
        <translation>コントローラの内部システムエラー</translation>
    </message>
    <message>
        <source>the transfer was dropped: nothing came in time</source>
        <translation>時間内に何も届かず、転送が打ち切られました</translation>
    </message>
    <message>
        <source>start the transfer again</source>
        <translation>転送をやり直してください</translation>
    </message>
    <message>
        <source>the file cannot be overwritten</source>
        <translation>ファイルを上書きできません</translation>
    </message>
    <message>
        <source>permit overwriting, or delete the file first</source>
        <translation>上書きを許可するか、先にファイルを削除してください</translation>
    </message>
    <message>
        <source>the file is missing or empty</source>
        <translation>ファイルがないか、空です</translation>
    </message>
    <message>
        <source>check the file name</source>
        <translation>ファイル名を確認してください</translation>
    </message>
    <message>
        <source>the path is wrong</source>
        <translation>パスに誤りがあります</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>パスを確認してください</translation>
    </message>
    <message>
        <source>the file is not in the list</source>
        <translation>ファイルが一覧にありません</translation>
    </message>
    <message>
        <source>the file may not be deleted</source>
        <translation>このファイルは削除できません</translation>
    </message>
    <message>
        <source>the directory may not be deleted</source>
        <translation>このディレクトリは削除できません</translation>
    </message>
    <message>
        <source>files cannot be accessed while remote is off</source>
        <translation>リモートがオフの間はファイルにアクセスできません</translation>
    </message>
    <message>
        <source>the file was not found</source>
        <translation>ファイルが見つかりませんでした</translation>
    </message>
    <message>
        <source>the path is too long</source>
        <translation>パスが長すぎます</translation>
    </message>
    <message>
        <source>use a shorter name</source>
        <translation>もっと短い名前を使ってください</translation>
    </message>
    <message>
        <source>packet without data</source>
        <translation>データのないパケット</translation>
    </message>
    <message>
        <source>packet too large</source>
        <translation>パケットが大きすぎます</translation>
    </message>
    <message>
        <source>packet of size 0</source>
        <translation>サイズ0のパケット</translation>
    </message>
    <message>
        <source>packet with a wrong block number</source>
        <translation>ブロック番号の違うパケット</translation>
    </message>
    <message>
        <source>packet with a wrong ACK byte</source>
        <translation>ACKバイトの違うパケット</translation>
    </message>
    <message>
        <source>packet of a wrong division</source>
        <translation>処理区分の違うパケット</translation>
    </message>
    <message>
        <source>check that robot and file port are not exchanged</source>
        <translation>ロボットポートとファイルポートが入れ替わっていないか確認してください</translation>
    </message>
    <message>
        <source>packet with a wrong access level</source>
        <translation>アクセスレベルの違うパケット</translation>
    </message>
    <message>
        <source>packet with a wrong header size</source>
        <translation>ヘッダサイズの違うパケット</translation>
    </message>
    <message>
        <source>packet with a wrong identifier</source>
        <translation>識別子の違うパケット</translation>
    </message>
    <message>
        <source>announced and received packet sizes differ</source>
        <translation>通知されたパケットサイズと受信したサイズが異なります</translation>
    </message>
    <message>
        <source>too many requests</source>
        <translation>要求が多すぎます</translation>
    </message>
    <message>
        <source>ask less often, or try again in a moment</source>
        <translation>要求の頻度を下げるか、しばらくしてからやり直してください</translation>
    </message>
    <message>
        <source>the mode was changed and the communication dropped</source>
        <translation>モードが変更され、通信が打ち切られました</translation>
    </message>
    <message>
        <source>start again in the new mode</source>
        <translation>新しいモードでやり直してください</translation>
    </message>
</context>
<context>
    <name>robot::Controller</name>
    <message>
        <source>The name %1 is not known to this computer.</source>
        <translation>%1という名前はこのコンピュータでは不明です。</translation>
    </message>
</context>
<context>
    <name>robot::Diagnosis</name>
    <message>
        <source>Host name</source>
        <translation>ホスト名</translation>
    </message>
    <message>
        <source>Way to the host</source>
        <translation>ホストへの経路</translation>
    </message>
    <message>
        <source>Robot port</source>
        <translation>ロボットポート</translation>
    </message>
    <message>
        <source>System information</source>
        <translation>システム情報</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>ファイルポート</translation>
    </message>
    <message>
        <source>Not looked at, because the step before it failed.</source>
        <translation>前の段階が不合格のため、確認していません。</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address on this computer.</source>
        <translation>名前「%1」のIPv4アドレスは、このコンピュータでは不明です。</translation>
    </message>
    <message>
        <source>Check the spelling, or enter the controller&apos;s IPv4 address as the pendant shows it.</source>
        <translation>つづりを確認するか、ペンダントに表示されるコントローラのIPv4アドレスを入力してください。</translation>
    </message>
    <message>
        <source>%1 is %2.</source>
        <translation>%1は%2です。</translation>
    </message>
    <message>
        <source>This computer cannot send to %1: %2.</source>
        <translation>このコンピュータから%1へ送信できません: %2。</translation>
    </message>
    <message>
        <source>Check the cable and this computer&apos;s IPv4 address: it must be in the controller&apos;s network.</source>
        <translation>ケーブルとこのコンピュータのIPv4アドレスを確認してください。コントローラと同じネットワークでなければなりません。</translation>
    </message>
    <message>
        <source>This computer can send to %1.</source>
        <translation>このコンピュータから%1へ送信できます。</translation>
    </message>
    <message>
        <source>Port %1 answers with a status.</source>
        <translation>ポート%1が状態を応答しています。</translation>
    </message>
    <message>
        <source>Port %1 answers but refuses to tell the status: %2</source>
        <translation>ポート%1は応答しますが、状態の読出しを拒否しています: %2</translation>
    </message>
    <message>
        <source>Check on the pendant that the network function server is enabled for this computer.</source>
        <translation>このコンピュータに対してネットワーク機能サーバが有効か、ペンダントで確認してください。</translation>
    </message>
    <message>
        <source>Answers come from another address than %1; they are ignored.</source>
        <translation>応答が%1とは別のアドレスから届いています。これらは無視します。</translation>
    </message>
    <message>
        <source>Look for a second network card or an address translation between this computer and the controller.</source>
        <translation>このコンピュータとコントローラの間に、2枚目のネットワークカードやアドレス変換がないか調べてください。</translation>
    </message>
    <message>
        <source>Something answers at port %1, but not with HSES.</source>
        <translation>ポート%1で何かが応答していますが、HSESではありません。</translation>
    </message>
    <message>
        <source>Check the address and the port: HSES is UDP %1 on a controller.</source>
        <translation>アドレスとポートを確認してください。コントローラのHSESはUDP %1です。</translation>
    </message>
    <message>
        <source>The host rejects port %1: %2.</source>
        <translation>ホストがポート%1を拒否しています: %2。</translation>
    </message>
    <message>
        <source>The host is there, but no HSES server: enable the Ethernet server function on the controller.</source>
        <translation>ホストはありますが、HSESサーバがありません。コントローラのEthernetサーバ機能を有効にしてください。</translation>
    </message>
    <message>
        <source>Port %1 stays silent.</source>
        <translation>ポート%1は応答しません。</translation>
    </message>
    <message>
        <source>Check that the controller is on, that its Ethernet server function is enabled and that no firewall drops UDP %1.</source>
        <translation>コントローラの電源が入っていること、Ethernetサーバ機能が有効なこと、ファイアウォールがUDP %1を遮断していないことを確認してください。</translation>
    </message>
    <message>
        <source>The controller runs %1.</source>
        <translation>コントローラのソフトウェアは%1です。</translation>
    </message>
    <message>
        <source>The controller does not tell its system information: %1</source>
        <translation>コントローラがシステム情報を知らせません: %1</translation>
    </message>
    <message>
        <source>Pendesk monitors only a controller that says what it is. Ask its maker for the HSES option.</source>
        <translation>Pendeskが監視するのは、自分の機種を知らせるコントローラだけです。HSESオプションについてメーカにお問い合わせください。</translation>
    </message>
    <message>
        <source>Port %1 stays silent: files are unavailable, monitoring works.</source>
        <translation>ポート%1は応答しません。ファイルは使えませんが、監視はできます。</translation>
    </message>
    <message>
        <source>Check that no firewall drops UDP %1.</source>
        <translation>ファイアウォールがUDP %1を遮断していないことを確認してください。</translation>
    </message>
    <message>
        <source>Port %1 answers.</source>
        <translation>ポート%1が応答しています。</translation>
    </message>
</context>
<context>
    <name>session::FileSession</name>
    <message>
        <source>An empty file cannot be sent over HSES.</source>
        <translation>空のファイルはHSESで送信できません。</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1は%2から%3までの整数にしてください。</translation>
    </message>
    <message>
        <source>The model “%1” is not known.</source>
        <translation>機種「%1」は不明です。</translation>
    </message>
    <message>
        <source>The text encoding “%1” is not known.</source>
        <translation>文字コード「%1」は不明です。</translation>
    </message>
    <message>
        <source>The variable numbering must be 0 or 1.</source>
        <translation>変数番号の方式は0または1にしてください。</translation>
    </message>
    <message>
        <source>Pulses per degree must be lists of numbers, one list for each control group.</source>
        <translation>1度あたりのパルス数は数値のリストで、制御グループごとに1つのリストにしてください。</translation>
    </message>
    <message>
        <source>The profile needs a name.</source>
        <translation>プロファイルには名前が必要です。</translation>
    </message>
    <message>
        <source>The profile needs the controller&apos;s host name or IPv4 address.</source>
        <translation>プロファイルには、コントローラのホスト名またはIPv4アドレスが必要です。</translation>
    </message>
</context>
<context>
    <name>settings::CommandLine</name>
    <message>
        <source>--%1 must be a whole number from 1 to 65535.</source>
        <translation>--%1は1から65535までの整数にしてください。</translation>
    </message>
    <message>
        <source>--timeout takes a time such as 300ms or 1s.</source>
        <translation>--timeoutには300msや1sのような時間を指定してください。</translation>
    </message>
    <message>
        <source>There is no controller stored under the name “%1”.</source>
        <translation>「%1」という名前で保存されたコントローラはありません。</translation>
    </message>
    <message>
        <source>Connect to the controller with this name or IPv4 address.</source>
        <translation>この名前またはIPv4アドレスのコントローラに接続します。</translation>
    </message>
    <message>
        <source>Its port for robot control, 10040 unless told otherwise.</source>
        <translation>ロボット制御用のポート。指定しなければ10040。</translation>
    </message>
    <message>
        <source>Its port for file control, 10041 unless told otherwise.</source>
        <translation>ファイル制御用のポート。指定しなければ10041。</translation>
    </message>
    <message>
        <source>Connect to the controller that is stored under this name.</source>
        <translation>この名前で保存されたコントローラに接続します。</translation>
    </message>
    <message>
        <source>How long to wait for one try of a read: 300ms, 1s.</source>
        <translation>読出し1回あたりの待ち時間: 300ms、1s。</translation>
    </message>
    <message>
        <source>--%1 needs --host or --profile.</source>
        <translation>--%1には--hostまたは--profileが必要です。</translation>
    </message>
    <message>
        <source>--model must be dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>--modelはdx100、dx200、fs100、yrc1000、yrc1000microのいずれかにしてください。</translation>
    </message>
    <message>
        <source>Its model: dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>その機種: dx100、dx200、fs100、yrc1000、yrc1000microのいずれか。</translation>
    </message>
    <message>
        <source>What to log, as &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</source>
        <translation>ログに記録するもの (例: &quot;pendesk.session=true;pendesk.journal.debug=false&quot;)。</translation>
    </message>
</context>
<context>
    <name>settings::Profile</name>
    <message>
        <source>Port</source>
        <translation>ポート</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>ファイルポート</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>読出しタイムアウト</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>ファイルタイムアウト</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>サーボタイムアウト</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>読出しの再試行回数</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>同時に応答を待つ要求数</translation>
    </message>
    <message>
        <source>Requests a second</source>
        <translation>1秒あたりの要求数</translation>
    </message>
</context>
<context>
    <name>settings::SettingsFile</name>
    <message>
        <source>The last good ones, of %1, are used.</source>
        <translation>最後の正常な設定 (%1) を使います。</translation>
    </message>
    <message>
        <source>There is no good copy of them.</source>
        <translation>正常な写しはありません。</translation>
    </message>
    <message>
        <source>The settings in %1 are gone.</source>
        <translation>%1の設定がなくなっています。</translation>
    </message>
    <message>
        <source>The settings cannot be read: %1.</source>
        <translation>設定を読み取れません: %1。</translation>
    </message>
    <message>
        <source>The settings are damaged; they are kept as %1.</source>
        <translation>設定が破損しています。%1として残しています。</translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation>別のプログラムが%1を使用しています</translation>
    </message>
    <message>
        <source>Settings could not be saved in time and are lost: %1</source>
        <translation>設定を時間内に保存できず、失われました: %1</translation>
    </message>
    <message>
        <source>Settings cannot be saved: %1. Work goes on; it is tried again.</source>
        <translation>設定を保存できません: %1。動作は続けます。保存はやり直します。</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the earlier settings cannot be read; they stay in %1.</source>
        <translation>
            <numerusform>以前の設定の%n項目を読み取れません。%1に残しています。</numerusform>
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
            <numerusform>書込み予定の%n個の値を適用していません。</numerusform>
        </translation>
    </message>
    <message>
        <source>Files are still being transferred.</source>
        <translation>まだファイルを転送しています。</translation>
    </message>
    <message>
        <source>Files are still being read or sent for a backup, a comparison or a restore.</source>
        <translation>バックアップ、比較または復元のために、まだファイルを読み出しまたは送信しています。</translation>
    </message>
</context>
<context>
    <name>trend</name>
    <message>
        <source>Alarm %1 [%2] %3</source>
        <translation>アラーム %1 [%2] %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>ジョブ %1</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation>ステップモード</translation>
    </message>
    <message>
        <source>One cycle</source>
        <translation>1サイクル</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>連続</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>運転中</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>速度制限</translation>
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
        <translation>ペンダントによるホールド中</translation>
    </message>
    <message>
        <source>Held externally</source>
        <translation>外部ホールド中</translation>
    </message>
    <message>
        <source>Held by command</source>
        <translation>コマンドによるホールド中</translation>
    </message>
    <message>
        <source>Alarm active</source>
        <translation>アラーム発生中</translation>
    </message>
    <message>
        <source>Error active</source>
        <translation>エラー発生中</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>サーボオン</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>ジョブ行</translation>
    </message>
    <message>
        <source>Job step</source>
        <translation>ジョブステップ</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>速度オーバーライド</translation>
    </message>
    <message>
        <source>%1, sub task %2</source>
        <translation>%1、サブタスク%2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 following error</source>
        <translation>%1 %2 位置偏差</translation>
    </message>
    <message>
        <source>%1 %2 torque</source>
        <translation>%1 %2 トルク</translation>
    </message>
    <message>
        <source>%1 %2 encoder temperature</source>
        <translation>%1 %2 エンコーダ温度</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>パルス</translation>
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
        <translation>コンバータ温度、基板%1</translation>
    </message>
    <message>
        <source>Running time %1</source>
        <translation>稼働時間 %1</translation>
    </message>
    <message>
        <source>Alarm code %1</source>
        <translation>アラームコード %1</translation>
    </message>
</context>
<context>
    <name>trend::Recorder</name>
    <message>
        <source>An incident is lost: %1 could not be written in time.</source>
        <translation>インシデントが失われました。%1に時間内に書き込めませんでした。</translation>
    </message>
</context>
<context>
    <name>ui::AccessSwitch</name>
    <message>
        <source>Passcode and idle time…</source>
        <translation>パスコードと無操作時間…</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>アクセスレベル: %1</translation>
    </message>
    <message>
        <source>This program was started with --monitor-only: it watches and holds.</source>
        <translation>このプログラムは--monitor-onlyで起動されています。監視とホールドだけを行います。</translation>
    </message>
    <message numerus="yes">
        <source>What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.</source>
        <translation>
            <numerusform>ここから行える操作の範囲です。%n分間キーもマウスも操作がないと「監視」に戻ります。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Announcer</name>
    <message>
        <source>New alarm %1: %2</source>
        <translation>新しいアラーム %1: %2</translation>
    </message>
</context>
<context>
    <name>ui::ArmBadge</name>
    <message>
        <source>This controller is armed: press to disarm.</source>
        <translation>このコントローラは動作許可中です。押すと解除します。</translation>
    </message>
    <message>
        <source>ARMED · %1 s</source>
        <translation>動作許可中 · %1 秒</translation>
    </message>
    <message numerus="yes">
        <source>Armed for %n more second(s). Press to disarm.</source>
        <translation>
            <numerusform>動作許可はあと%n秒です。押すと解除します。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::BackupAge</name>
    <message>
        <source>No backup</source>
        <translation>バックアップなし</translation>
    </message>
    <message numerus="yes">
        <source>Backup %n hour(s) old</source>
        <translation>
            <numerusform>バックアップは %n 時間前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Backup %n day(s) old</source>
        <translation>
            <numerusform>バックアップは %n 日前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Old backup: %n day(s)</source>
        <translation>
            <numerusform>古いバックアップ: %n 日</numerusform>
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
        <translation>%1のHLOCKがオンです。ペンダントは非常停止を除いて操作できません。</translation>
    </message>
    <message>
        <source>Release HLOCK</source>
        <translation>HLOCKを解除</translation>
    </message>
    <message numerus="yes">
        <source>The journal works again. %n record(s) were lost.</source>
        <translation>
            <numerusform>操作履歴は復旧しました。%n件の記録が失われました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal was damaged. It was kept as %1, and a new one was begun.</source>
        <translation>操作履歴が破損していました。%1として残し、新しい操作履歴を始めました。</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Level: %1</source>
        <translation>レベル: %1</translation>
    </message>
    <message>
        <source>HLOCK is on</source>
        <translation>HLOCKがオンです</translation>
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
        <translation>デモを開始できませんでした: %1。</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Pendeskについて</translation>
    </message>
    <message>
        <source>Pendesk %1

A teach and monitor desk for Yaskawa robot controllers.
Free software under the GNU General Public License, version 3 or later.

HOLD is a software hold over the network, not a safety function.</source>
        <translation>Pendesk %1

安川電機のロボットコントローラ用のティーチ・監視デスクです。
GNU General Public License バージョン3またはそれ以降に基づくフリーソフトウェアです。

HOLDはネットワーク経由のソフトウェアホールドであり、安全機能ではありません。</translation>
    </message>
    <message>
        <source>There is no connection.</source>
        <translation>接続していません。</translation>
    </message>
    <message>
        <source>The connection is open.</source>
        <translation>接続しています。</translation>
    </message>
    <message>
        <source>No controller is chosen.</source>
        <translation>コントローラを選んでいません。</translation>
    </message>
    <message>
        <source>No controller is chosen: connect first.</source>
        <translation>コントローラを選んでいません。先に接続してください。</translation>
    </message>
    <message>
        <source>%1 requests/s</source>
        <translation>%1 要求/秒</translation>
    </message>
    <message>
        <source>Something is unfinished</source>
        <translation>完了していないものがあります</translation>
    </message>
    <message>
        <source>Go on and lose it</source>
        <translation>破棄して続行</translation>
    </message>
    <message>
        <source>HLOCK is still on at %1: the pendant stays locked out if you go on.</source>
        <translation>%1のHLOCKがまだオンです。続行すると、ペンダントは操作できないままになります。</translation>
    </message>
    <message>
        <source>Release HLOCK and go on</source>
        <translation>HLOCKを解除して続行</translation>
    </message>
    <message>
        <source>Go on and leave it on</source>
        <translation>オンのまま続行</translation>
    </message>
</context>
<context>
    <name>ui::NavigationRail</name>
    <message>
        <source>CONTROLLERS</source>
        <translation>コントローラ</translation>
    </message>
    <message>
        <source>PAGES</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>CONNECTION</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
</context>
<context>
    <name>ui::RobotStrip</name>
    <message>
        <source>SIMULATION</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>コントローラなし</translation>
    </message>
    <message>
        <source>Link · %1 ago</source>
        <translation>リンク · %1前</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>途絶</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>確認中…</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未接続</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>サーボ</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運転</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>ホールド</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>アラーム</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>ジョブ</translation>
    </message>
    <message>
        <source>Job · %1</source>
        <translation>ジョブ · %1</translation>
    </message>
</context>
<context>
    <name>ui::StationList</name>
    <message numerus="yes">
        <source>%n more in Fleet</source>
        <translation>
            <numerusform>ほか%n台はフリートに表示</numerusform>
        </translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>コントローラなし</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>未接続</translation>
    </message>
</context>
<context>
    <name>values</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8ビット</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>conveyor files</source>
        <translation>コンベヤファイル</translation>
    </message>
    <message>
        <source>robots and stations</source>
        <translation>ロボットとステーション</translation>
    </message>
    <message>
        <source>signed number</source>
        <translation>符号付きの数</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16ビット</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>ロボット</translation>
    </message>
    <message>
        <source>robots, stations and bases</source>
        <translation>ロボット、ステーション、ベース</translation>
    </message>
    <message>
        <source>control group, low and high axes</source>
        <translation>制御グループ、下位軸と上位軸</translation>
    </message>
    <message>
        <source>control group, minimum and maximum axes</source>
        <translation>制御グループ、軸の最小と最大</translation>
    </message>
    <message>
        <source>control group, minimum and maximum X Y Z</source>
        <translation>制御グループ、X Y Zの最小と最大</translation>
    </message>
    <message>
        <source>axes of two control groups</source>
        <translation>2つの制御グループの軸</translation>
    </message>
    <message>
        <source>two sets of axes of a control group</source>
        <translation>1つの制御グループの2組の軸</translation>
    </message>
    <message>
        <source>axes of a control group and a number</source>
        <translation>制御グループの軸と番号</translation>
    </message>
    <message>
        <source>control group and a number</source>
        <translation>制御グループと番号</translation>
    </message>
    <message>
        <source>unknown type %1</source>
        <translation>不明なタイプ %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>back</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>上腕</translation>
    </message>
    <message>
        <source>lower arm</source>
        <translation>下腕</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>フリップ</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>ノーフリップ</translation>
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
        <translation>冗長正面</translation>
    </message>
    <message>
        <source>redundant back</source>
        <translation>冗長背面</translation>
    </message>
    <message>
        <source>previous step&apos;s form</source>
        <translation>前ステップの形態</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>この形態</translation>
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
        <translation>パルス</translation>
    </message>
    <message>
        <source>base frame</source>
        <translation>ベース座標</translation>
    </message>
    <message>
        <source>robot frame</source>
        <translation>ロボット座標</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>ユーザ座標</translation>
    </message>
    <message>
        <source>tool frame</source>
        <translation>ツール座標</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>グループ%1</translation>
    </message>
    <message numerus="yes">
        <source>… (%n more characters)</source>
        <translation>
            <numerusform>… (ほか%n文字)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>variables::Sentences</name>
    <message>
        <source>Line %1: a cell begins with a quotation mark and does not end with one.</source>
        <translation>%1行目: セルが引用符で始まっていますが、引用符で終わっていません。</translation>
    </message>
    <message>
        <source>Line %1: there is text behind the quotation mark that ends a cell.</source>
        <translation>%1行目: セルを閉じる引用符の後に文字があります。</translation>
    </message>
    <message>
        <source>The file is not UTF-8: save it as “CSV UTF-8” and try again.</source>
        <translation>ファイルがUTF-8ではありません。「CSV UTF-8」で保存してからやり直してください。</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>「%1」は数値ではありません。</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be from %2 to %3.</source>
        <translation>%1は範囲外です。%2から%3までにしてください。</translation>
    </message>
    <message>
        <source>“%1” is not a whole number: write it without decimals and separators.</source>
        <translation>「%1」は整数ではありません。小数点や区切りを付けずに書いてください。</translation>
    </message>
    <message>
        <source>%1 does not go into a real: that is 0, or from ±1.18e-38 to ±3.40e+38.</source>
        <translation>%1は実数型に入りません。使えるのは0、または±1.18e-38から±3.40e+38までです。</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>数値ではありません</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>「%1」は整数ではありません。</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is too fine: %n decimal(s) are kept.</source>
        <translation>
            <numerusform>「%1」は細かすぎます。小数は%n桁まで保持します。</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is not a variable. Write its letter and its number, such as B007.</source>
        <translation>「%1」は変数ではありません。B007のように文字と番号で書いてください。</translation>
    </message>
    <message>
        <source>There is no %1: this controller has %2 to %3.</source>
        <translation>%1はありません。このコントローラには%2から%3まであります。</translation>
    </message>
    <message>
        <source>“%1” is not a range: it must go from a lower to a higher number of one kind.</source>
        <translation>「%1」は範囲ではありません。同じ種類の小さい番号から大きい番号までにしてください。</translation>
    </message>
    <message>
        <source>“%1” is not a type that %2 has.</source>
        <translation>「%1」は%2のタイプにありません。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>column: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing, and no value of this type was read.</source>
        <translation>%1がなく、このタイプの値も読み出していません。</translation>
    </message>
    <message>
        <source>The type is missing, and none was read.</source>
        <translation>タイプがなく、読み出してもいません。</translation>
    </message>
    <message>
        <source>The variable is missing.</source>
        <translation>変数がありません。</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1は読出し専用です。</translation>
    </message>
    <message>
        <source>%1 stands in line %2 already.</source>
        <translation>%1はすでに%2行目にあります。</translation>
    </message>
    <message>
        <source>The value is missing.</source>
        <translation>値がありません。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>variable: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The column “%1” stands there twice.</source>
        <translation>列「%1」が2つあります。</translation>
    </message>
    <message>
        <source>The header is missing: the first line must name the columns “variable” and “value”.</source>
        <translation>ヘッダがありません。1行目に列名「variable」と「value」が必要です。</translation>
    </message>
    <message>
        <source>There is neither a column “value” nor “axis 1”.</source>
        <translation>列「value」も「axis 1」もありません。</translation>
    </message>
    <message>
        <source>The line has more cells than the header.</source>
        <translation>この行のセルがヘッダより多いです。</translation>
    </message>
    <message>
        <source>A block without a header has one or two columns.</source>
        <translation>ヘッダのないブロックは1列または2列です。</translation>
    </message>
    <message>
        <source>The text cannot be sent: %1.</source>
        <translation>この文字列は送信できません: %1。</translation>
    </message>
    <message>
        <source>The text must not hold the character NUL, which ends it.</source>
        <translation>文字列に、終端を示すNUL文字を含めることはできません。</translation>
    </message>
    <message>
        <source>The text takes %1 bytes; there is room for %2.</source>
        <translation>文字列は%1バイトですが、入るのは%2バイトまでです。</translation>
    </message>
    <message>
        <source>A position is not written as one text.</source>
        <translation>位置は1つの文字列では書き込めません。</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>実数</translation>
    </message>
    <message numerus="yes">
        <source>up to %n byte(s)</source>
        <translation>
            <numerusform>最大%nバイト</numerusform>
        </translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>パルス</translation>
    </message>
</context>
<context>
    <name>widgets::ArmControl</name>
    <message>
        <source>Hold for 1 s to arm</source>
        <translation>1秒間長押しで動作許可</translation>
    </message>
    <message>
        <source>Why not?</source>
        <translation>できない理由は?</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>動作許可を解除</translation>
    </message>
    <message>
        <source>Nobody is inside the fence</source>
        <translation>安全柵の中に人はいません</translation>
    </message>
    <message>
        <source>I see the robot, or somebody who does</source>
        <translation>ロボットが自分または見張りの人から見えます</translation>
    </message>
    <message>
        <source>An emergency stop is within reach there</source>
        <translation>現場で非常停止に手が届きます</translation>
    </message>
    <message>
        <source>Armed: start, servo on and moves are possible. It drops after a minute without key or mouse.</source>
        <translation>動作許可中: 起動、サーボオン、移動ができます。1分間キーもマウスも操作がないと解除されます。</translation>
    </message>
    <message>
        <source>Disarmed at %1: %2.</source>
        <translation>動作許可を解除 (%1): %2。</translation>
    </message>
    <message>
        <source>Tick all three first.</source>
        <translation>先に3つすべてにチェックを付けてください。</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
</context>
<context>
    <name>widgets::CellEditor</name>
    <message>
        <source>live: %1</source>
        <translation>ライブ: %1</translation>
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
        <translation>両方の版の行</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>古い版</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>新しい版</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>ほか%n件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::GoToEdit</name>
    <message>
        <source>Go to</source>
        <translation>ジャンプ</translation>
    </message>
    <message>
        <source>Go to…  Ctrl+G</source>
        <translation>ジャンプ…  Ctrl+G</translation>
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
        <translation>HOLD (ソフトウェア)</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>ソフトウェアホールド · Pauseキー</translation>
    </message>
</context>
<context>
    <name>widgets::JobView</name>
    <message>
        <source>Job text</source>
        <translation>ジョブの内容</translation>
    </message>
</context>
<context>
    <name>widgets::JogPad</name>
    <message>
        <source>Jog %1 forward</source>
        <translation>%1を正方向にジョグ</translation>
    </message>
    <message>
        <source>Jog %1 back</source>
        <translation>%1を負方向にジョグ</translation>
    </message>
</context>
<context>
    <name>widgets::LogicStrip</name>
    <message>
        <source>The watched signals over the last minute</source>
        <translation>直近1分間のウォッチ中の信号</translation>
    </message>
    <message>
        <source>now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>−%1 s</source>
        <translation>−%1 秒</translation>
    </message>
</context>
<context>
    <name>widgets::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
</context>
<context>
    <name>widgets::OrderButton</name>
    <message>
        <source>Why not?</source>
        <translation>できない理由は?</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>Conditions of: %1</source>
        <translation>%1の条件</translation>
    </message>
    <message>
        <source>Pending…</source>
        <translation>処理中…</translation>
    </message>
</context>
<context>
    <name>widgets::Plot</name>
    <message>
        <source>seconds</source>
        <translation>秒</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Nothing is plotted.</source>
        <translation>何もプロットしていません。</translation>
    </message>
</context>
<context>
    <name>widgets::Plottables</name>
    <message>
        <source>Add to trend: %1</source>
        <translation>トレンドに追加: %1</translation>
    </message>
</context>
<context>
    <name>widgets::Question</name>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
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
        <translation>直近60秒の往復時間: まだありません。</translation>
    </message>
    <message>
        <source>Round trips of the last 60 seconds: longest %1 ms, lost tries in %2 s.</source>
        <translation>直近60秒の往復時間: 最長%1 ms、%2秒に消失あり。</translation>
    </message>
</context>
<context>
    <name>widgets::ToolPathView</name>
    <message>
        <source>Top</source>
        <translation>上面</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側面</translation>
    </message>
    <message>
        <source>Tool path, %1 view</source>
        <translation>ツール軌跡、%1図</translation>
    </message>
    <message>
        <source>No position in the base frame was read yet.</source>
        <translation>ベース座標の位置をまだ読み出していません。</translation>
    </message>
    <message>
        <source>%1 %2 mm, %3 %4 mm. %5</source>
        <translation>%1 %2 mm、%3 %4 mm。%5</translation>
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
        <translation>%1、%2</translation>
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
        <translation>%1。%2</translation>
    </message>
</context>
</TS>
